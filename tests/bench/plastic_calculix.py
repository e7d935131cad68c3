#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the cost of a Newton iteration of flowing rock, over one of CalculiX (Debian package calculix-ccx) on the same triangles, by the same law.
The problem is Cook's membrane under plane strain, von Mises with linear hardening (benchmark pla-11). CalculiX 2.20 has no Mohr-Coulomb surface.

The cost of an iteration is the difference of two runs of different length over their iterations. Each run is the fastest of three, on one thread and
in processor time. Keyblock computes large strain and averages over covers. CalculiX computes small strain (*STATIC without NLGEOM) on triangles of
constant strain, which it makes wedges. The bench is skipped if `ccx` is not installed. Times alone mean nothing on another machine."""
import argparse
import json
import os
import pathlib
import shutil
import sys
import tempfile
import xml.etree.ElementTree as xml

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "legacy_cases"))
from cover_files import case_text  # noqa: E402
from processor_time import timed  # noqa: E402

REPEATS = 3
STEPS = 10  # of the whole load, 1.5 over the edge of 16
YOUNG, POISSON, YIELD, HARDENING = 70, 1 / 3, 0.00243, 0.135
LOAD = 1.5 / 16 / 100


def cook(side, steps):
    covers = {"mesh": {"kind": "unstructured", "placement": "aligned", "side": side}, "displacements": [{"along": [(0, 44), (0, 0)]}],
              "tractions": [{"along": [(48, 44), (48, 60)], "y": LOAD * steps / STEPS}]}
    strength = {"surface": "von_mises", "yield_stress": YIELD, "after": {"plastic_strain": 1, "yield_stress": YIELD + HARDENING}}
    return case_text([(0, 0), (48, 44), (48, 60), (0, 44)], covers, YOUNG, POISSON, [(48, 60)], plane_strain=True, steps=(steps, 0.15), strength=strength)


class Round:
    """Returns, for the longer of two runs, seconds per iteration, unknowns, iterations, displacement of the upper corner."""

    def __init__(self, runs):
        (short, fewer, _, _), (long, more, self.unknowns, self.corner) = runs
        self.seconds, self.rounds = (long - short) / (more - fewer), more


def by_keyblock(program, side, steps, folder):
    file = folder / "in.json"
    file.write_text(cook(side, steps))
    out = folder / ("out_%d" % steps)
    done, seconds = timed([program, "run", str(file), "--threads", "1", "--frames", "text", "-o", str(out), "--force"])
    if done.returncode not in (0, 1):
        raise RuntimeError(done.stderr)
    report = json.loads((out / "run.json").read_text())
    lines = (out / "history.csv").read_text().splitlines()
    corner = float(lines[-1].split(",")[[name.split(" [")[0] for name in lines[0].split(",")].index("dy1")])
    return seconds, report["counts"]["passes"], report["counts"]["unknowns"], corner


def without_straight_corners(places):
    """An edge of a body may have corners where round-off brings a neighbouring triangle to it."""
    cross = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    size = max(abs(cross(places[0], places[1], p)) + abs(cross(places[0], p, places[-1])) for p in places)
    return [p for i, p in enumerate(places) if abs(cross(places[i - 1], p, places[(i + 1) % len(places)])) > 1e-9 * size]


def triangles_of(out):
    """Nodes and triangles of the first frame."""
    piece = xml.parse(sorted((out / "frames").glob("*.vtu"))[0]).getroot().find("UnstructuredGrid/Piece")
    numbers = [float(word) for word in piece.find("Points/DataArray").text.split()]
    corners = [(numbers[i], numbers[i + 1]) for i in range(0, len(numbers), 3)]
    cells = {array.get("Name"): [int(word) for word in array.text.split()] for array in piece.find("Cells")}
    nodes, triangles, begin = {}, [], 0
    for end in cells["offsets"]:
        places = without_straight_corners([corners[c] for c in cells["connectivity"][begin:end]])
        if len(places) != 3:
            raise RuntimeError("a mesh that follows the body has triangles alone, here are %d corners" % len(places))
        triangles.append([nodes.setdefault((round(x, 9), round(y, 9)), len(nodes) + 1) for x, y in places])
        begin = end
    return list(nodes), triangles


def input_of(nodes, triangles, steps):
    text = ["*NODE, NSET=ALL"] + ["%d,%.12g,%.12g,0" % (i + 1, x, y) for i, (x, y) in enumerate(nodes)]
    text += ["*ELEMENT, TYPE=CPE3, ELSET=BODY"] + ["%d,%d,%d,%d" % (i + 1, *t) for i, t in enumerate(triangles)]
    text += ["*MATERIAL, NAME=M", "*ELASTIC", "%.12g,%.12g" % (YOUNG, POISSON), "*PLASTIC", "%.12g,0" % YIELD, "%.12g,1" % (YIELD + HARDENING),
             "*SOLID SECTION, ELSET=BODY, MATERIAL=M", "1", "*BOUNDARY"]
    text += ["%d,1,2,0" % (i + 1) for i, (x, _) in enumerate(nodes) if abs(x) < 1e-9]
    edge = sorted((y, i + 1) for i, (x, y) in enumerate(nodes) if abs(x - 48) < 1e-9)
    loads = dict.fromkeys([node for _, node in edge], 0.0)
    for (low, a), (high, b) in zip(edge, edge[1:]):
        for node in (a, b):
            loads[node] += LOAD * steps / STEPS * (high - low) / 2
    text += ["*NSET, NSET=CORNER", "%d" % edge[-1][1], "*STEP, INC=1000", "*STATIC, DIRECT", "%g,%g" % (1 / STEPS, steps / STEPS), "*CLOAD"]
    text += ["%d,2,%.12g" % entry for entry in loads.items()]
    return "\n".join(text + ["*NODE PRINT, NSET=CORNER, FREQUENCY=1000", "U", "*END STEP"]) + "\n"


def by_calculix(nodes, triangles, steps, folder):
    (folder / "cook.inp").write_text(input_of(nodes, triangles, steps))
    done, seconds = timed(["ccx", "cook"], cwd=folder, env=dict(os.environ, OMP_NUM_THREADS="1"))
    increments = [line.split() for line in (folder / "cook.sta").read_text().splitlines() if line.split() and line.split()[0].isdigit()]
    if done.returncode or len(increments) != steps:
        raise RuntimeError("ccx made %d of %d increments:\n%s" % (len(increments), steps, done.stdout[-2000:]))
    words = done.stdout.split()
    equations = [int(words[i - 3]) for i in range(3, len(words)) if words[i - 2:i + 1] == ["of", "equations"] and words[i - 3].isdigit()]
    rows = [line.split() for line in (folder / "cook.dat").read_text().splitlines()]
    corner = [float(row[2]) for row in rows if len(row) == 4 and row[0].isdigit()][-1]
    return seconds, sum(int(row[3]) for row in increments), equations[-1] if equations else 2 * len(nodes), corner


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--steps", type=int, nargs=2, default=(6, 10))
    parser.add_argument("--sides", type=float, nargs="+", default=(1.4, 0.7))
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    if not shutil.which("ccx"):
        print("skipped: CalculiX (Debian package calculix-ccx) is not installed")
        return 0
    print("A Newton iteration on a yielding Cook's membrane, over one of CalculiX on the same triangles (above 1: Keyblock is slower)")
    print("%5s %-9s %9s %9s %7s %10s %10s %7s" % ("side", "program", "triangles", "unknowns", "iters", "ms/iter", "corner", "ratio"))
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for side in arguments.sides:
            ours = Round([min(by_keyblock(arguments.program, side, steps, folder) for _ in range(REPEATS)) for steps in arguments.steps])
            nodes, triangles = triangles_of(folder / ("out_%d" % arguments.steps[1]))
            theirs = Round([min(by_calculix(nodes, triangles, steps, folder) for _ in range(REPEATS)) for steps in arguments.steps])
            for program, made in (("Keyblock", ours), ("CalculiX", theirs)):
                ratio = made.seconds / theirs.seconds
                print("%5g %-9s %9d %9d %7d %10.1f %10.6f %7.2f" % (side, program, len(triangles), made.unknowns, made.rounds, 1000 * made.seconds,
                      made.corner, ratio), flush=True)
                rows.append({"side": side, "program": program, "triangles": len(triangles), "unknowns": made.unknowns, "rounds": made.rounds,
                             "seconds": made.seconds, "corner": made.corner, "ratio": ratio})
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
