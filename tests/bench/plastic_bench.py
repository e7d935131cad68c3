#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the cost of a Newton iteration of flowing rock, over one of elastic rock with derived functions on the same mesh. The limit is 1.5.
Measures also the time in which a footing of 5,414 unknowns collapses. The limit is a minute. The exit code is 1 if one limit is exceeded.

The cost of an iteration is the difference of two runs of different length over their iterations, so that reading, meshing and writing do not count.
Each run is the fastest of three, in processor time of one thread. The other work of a step (places, frames) counts too. An elastic step has one
iteration, which carries all of it. Elastoplastic rock with derived functions has as many iterations per step as with constant ones, and is the
stricter measure. Times alone mean nothing on another machine."""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "legacy_cases"))
from cover_files import case_text  # noqa: E402
from processor_time import timed  # noqa: E402

REPEATS = 3
ASKED = 1.5
COLLAPSE_SECONDS = 60


def coulomb(cohesion, angle=10):
    return {"surface": "mohr_coulomb", "cohesion": cohesion, "friction_deg": angle, "dilation_deg": angle}


def footing(edge, far, strength, functions, settlement=1e-4, steps=40):
    corners = [(0, -5), (5, -5), (5, 0), (1, 0), (0, 0)]
    covers = {"mesh": {"kind": "unstructured", "placement": "aligned", "side": far, "refined": [(1, 0, 0.35 * edge)]},
              "functions": functions,
              "displacements": [{"along": [(0, -5), (5, -5)]}, {"along": [(0, -5), (0, 0)], "held": "normal"},
                                {"along": [(5, -5), (5, 0)], "held": "normal"}, {"along": [(0, 0), (1, 0)], "held": "y", "y": -settlement}]}
    return case_text(corners, covers, 1e7, 0.3, [(0.5, 0)], plane_strain=True, steps=(steps, 1), strength=strength)


def run(program, text, steps, folder):
    file = pathlib.Path(folder) / "in.json"
    case = json.loads(text)
    # The first of the same steps: those of a shorter run are as long.
    case["analysis"]["step_count"] = steps
    case["covers"]["displacements"][-1]["y"] *= steps / 40
    file.write_text(json.dumps(case))
    command = [program, "run", str(file), "--threads", "1", "-o", str(pathlib.Path(folder) / "out"), "--force"]
    done, seconds = timed(command)
    if done.returncode not in (0, 1):
        raise RuntimeError(done.stderr)
    return seconds, json.loads((pathlib.Path(folder) / "out" / "run.json").read_text())


def round_of(program, text, lengths, folder):
    """Seconds per iteration, unknowns, iterations and yielded fraction of the longer run."""
    least = {}
    for _ in range(REPEATS):
        for steps in lengths:
            seconds, report = run(program, text, steps, folder)
            rounds = report["counts"]["passes"]
            if steps not in least or seconds < least[steps][0]:
                least[steps] = seconds, rounds
    (short, fewer), (long, more) = (least[steps] for steps in lengths)
    return (long - short) / (more - fewer), report["counts"]["unknowns"], more, report["plastic"]["yielding_fraction"]


def collapse(program, folder):
    """Rows of footings whose load is constant at the end: seconds of the whole run, and the growth of load over settlement in the last step."""
    print("A footing to collapse, flow associated, 24 steps (limit: %d s)" % COLLAPSE_SECONDS)
    print("%5s %9s %7s %9s %8s %8s" % ("phi", "unknowns", "iters", "Nc", "slope", "seconds"))
    rows = []
    for angle in (10, 20, 30):
        file, out = pathlib.Path(folder) / "collapse.json", pathlib.Path(folder) / "collapse"
        file.write_text(footing(0.04, 0.16, coulomb(10, angle), "constant", 1.2e-4 if angle == 10 else 2e-4, 24))
        done = subprocess.run([program, "run", str(file), "-o", str(out), "--force"], capture_output=True, text=True)
        if done.returncode not in (0, 1):
            raise RuntimeError(done.stderr)
        report = json.loads((out / "run.json").read_text())
        lines = [line.split(",") for line in (out / "history.csv").read_text().splitlines()]
        load = lines[0].index(next(name for name in lines[0] if name.startswith("reaction4_y")))
        before, last = (-float(line[load]) for line in lines[-2:])
        row = {"phi": angle, "unknowns": report["counts"]["unknowns"], "rounds": report["counts"]["passes"], "nc": last / 10,
               "slope": (last - before) / last * 24, "seconds": report["seconds"]["run"]}
        print("%5d %9d %7d %9.4f %8.4f %8.1f" % tuple(row.values()), flush=True)
        rows.append(row)
    return rows


def missed(rows, collapsed):
    """Returns one sentence per exceeded limit."""
    sentences = ["side %g: an iteration of elastoplastic rock costs %.2f iterations of elastic rock, limit %g" % (row["side"], row["ratio"], ASKED)
                 for row in rows if row["rock"] == "yields, constant" and row["ratio"] > ASKED]
    return sentences + ["phi %d: %.0f s to collapse, limit %d s" % (row["phi"], row["seconds"], COLLAPSE_SECONDS)
                        for row in collapsed if row["seconds"] > COLLAPSE_SECONDS]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--steps", type=int, nargs=2, default=(10, 40))
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    print("A Newton iteration on a footing, over that of elastic rock with derived functions on the same mesh (limit: %.1f)" % ASKED)
    print("%9s %-28s %8s %7s %9s %10s %7s" % ("mesh", "rock", "unknowns", "iters", "yielding", "ms/iter", "ratio"))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for edge, far in ((0.1, 0.3), (0.04, 0.16)):
            elastic = None
            for rock, cohesion, functions in (("elastic, derived", 1e9, "derived"), ("elastic, constant", 1e9, "constant"), ("yields, constant", 10, "constant"),
                                              ("yields, derived", 10, "derived")):
                seconds, unknowns, rounds, yielding = round_of(arguments.program, footing(edge, far, coulomb(cohesion), functions), arguments.steps, folder)
                elastic = elastic or seconds
                print("%9g %-28s %8d %7d %8.1f%% %10.1f %7.2f" % (far, rock, unknowns, rounds, 100 * yielding, 1000 * seconds, seconds / elastic), flush=True)
                rows.append({"side": far, "rock": rock, "unknowns": unknowns, "rounds": rounds, "yielding": yielding, "seconds": seconds, "ratio": seconds / elastic})
        print()
        collapsed = collapse(arguments.program, folder)
    if arguments.json:
        arguments.json.write_text(json.dumps({"rounds": rows, "collapse": collapsed}, indent=1) + "\n")
    sentences = missed(rows, collapsed)
    for sentence in sentences:
        print("missed: " + sentence)
    return 1 if sentences else 0


if __name__ == "__main__":
    sys.exit(main())
