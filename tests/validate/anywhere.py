#!/usr/bin/env python3
"""Runs slopes that move at other places, angles and units, and with noise, and compares where their blocks end.

usage: anywhere.py PROGRAM [CASE.json...]    with the package keyblock on PYTHONPATH

Without cases, four slopes are drawn from joint sets. A case has `blocks` and one block material, in metres. Each runs
0.5 s with slivers glued and kept. Fails if a variant releases 0.1 % more or less energy than the case as drawn, or if a
block above a fifth of the mean area ends 1 % of the greatest displacement elsewhere. Prints the same figures for halved
and quartered steps, without a limit.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import copy
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import numpy as np

    import keyblock as kb
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(0)

MOST_ENERGY = 1e-3
MOST_WAY = 1e-2
LARGE = 0.2  # of the mean area
SPAN = 0.5
TIME_STEP = 0.002
GRAVITY = 9.81
NOISE = 1e-9

# Outline, joint sets, seed and friction of the slopes.
SLOPES = {
    "face of 60": ("height=10,angle=60,toe=6,crest=10,base=4", "dip=35,spacing=1.3,scatter=0.15,joint=1",
                   "dip=110,spacing=1.6,trace=6,gap=0.6,scatter=0.2,joint=1", 3, 25),
    "face of 70": ("height=12,angle=70,toe=6,crest=12,base=4", "dip=28,spacing=1.5,scatter=0.1,joint=1",
                   "dip=95,spacing=1.8,trace=7,gap=0.8,scatter=0.2,joint=1", 7, 22),
    "face of 75": ("height=10,angle=75,toe=5,crest=9,base=3", "dip=40,spacing=1.2,trace=6,gap=0.4,scatter=0.25,joint=1",
                   "dip=140,spacing=1.5,scatter=0.2,joint=1", 11, 25),
    "face of 55": ("height=15,angle=55,toe=6,crest=12,base=4", "dip=45,spacing=1.8,scatter=0.2,joint=1",
                   "dip=85,spacing=2.2,trace=9,gap=1,scatter=0.3,joint=1", 21, 30),
}
ROCK = {"density": 2600, "unit_weight": 0, "youngs_modulus": 8e9, "poissons_ratio": 0.22}
ANALYSIS = {"dialect": "berkeley", "velocity_carry_over": 1, "step_count": 1, "time_step": TIME_STEP,
            "allowed_displacement_ratio": 0.01, "penalty_factor": 50, "plane_strain": True, "gravity": GRAVITY,
            "block_materials": [ROCK]}


def drawn(program, folder, outline, first, second, seed, friction):
    """Returns the case of a slope, with its blocks cut."""
    drawing, blocks, case = folder / "drawing.json", folder / "cut.blk", folder / "case.json"
    for words in (["joints", "--slope", outline, "--set", first, "--set", second, "--seed", str(seed), "--fix-sides",
                   "-o", drawing, "--force"], ["convert", drawing, "-o", blocks, "--to", "dda-blocks", "--force"],
                  ["convert", blocks, "-o", case, "--force"]):
        subprocess.run([program, *words], check=True, capture_output=True)
    made = json.loads(case.read_text())
    made["analysis"] = ANALYSIS | {"joint_materials": [{"friction_angle_deg": friction}]}
    return made


def points_of(case):
    """Returns the rows [x, y, ...] of all corners and fixed points, as they stand in the case."""
    blocks = case["blocks"]
    for block in blocks["blocks"]:
        for loop in [block["outer"], *block.get("holes", [])]:
            yield from loop
    yield from blocks.get("fixed_points", [])


def placed(case, shift=0.0, turn=0.0, noise=0.0, unit=1.0):
    """Returns the case moved by `shift` in both directions, turned by `turn` degrees, or in units of 1/`unit` m."""
    case, dice, c, s = copy.deepcopy(case), random.Random(1), math.cos(math.radians(turn)), math.sin(math.radians(turn))
    moved = {}
    for point in points_of(case):
        key = point[0], point[1]
        if key not in moved:
            x, y = (at + dice.uniform(-noise, noise) for at in key)
            moved[key] = unit * (c * x - s * y) + shift, unit * (s * x + c * y) + shift
        point[0], point[1] = moved[key]
    analysis = case["analysis"]
    analysis["gravity"] = analysis.get("gravity", GRAVITY) * unit
    for rock in analysis["block_materials"]:
        rock["density"] /= unit**3
        rock["youngs_modulus"] /= unit
        rock["unit_weight"] = 0
    return case


def end_of(case, folder, slivers, time_step=TIME_STEP, turn=0.0, unit=1.0):
    """Returns displacements [m] in the axes of the drawing, and areas [m²], after SPAN."""
    file, g, angle = folder / "placed.json", GRAVITY * unit, math.radians(turn)
    file.write_text(json.dumps(case))
    run = kb.Run(kb.read(file), settings={
        "time_step": f"{time_step:.17g}", "steps": str(round(SPAN / time_step)), "slivers": slivers,
        "gravity.x": f"{g * math.sin(angle):.17g}", "gravity.y": f"{-g * math.cos(angle):.17g}"})
    run.go_on()
    frame = run.frame()
    back = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    return np.asarray(frame.displacement) @ back / unit, np.asarray(frame.area) / unit**2


VARIANTS = {"+1e3 m": {"shift": 1e3}, "+1e6 m": {"shift": 1e6}, "1 deg": {"turn": 1}, "37 deg": {"turn": 37},
            "90 deg": {"turn": 90}, "mm": {"unit": 1e3}, "noise 1e-9 m": {"noise": NOISE}}


def compared(name, case, folder, slivers):
    """Prints a line per variant; returns the number beyond the limits."""
    base, area = end_of(placed(case), folder, slivers)
    weight = area * case["analysis"]["block_materials"][0]["density"] * GRAVITY
    released, farthest = float(-weight @ base[:, 1]), np.hypot(*base.T).max()
    misses = 0

    def line(label, ways, is_limited):
        energy = abs(float(-weight @ ways[:, 1]) - released) / abs(released)
        apart = np.hypot(*(ways - base).T)
        way = apart[area > LARGE * area.mean()].max() / farthest
        missed = is_limited and not (energy <= MOST_ENERGY and way <= MOST_WAY)
        print(f"{name:<12} {slivers:<5} {label:<13} energy {energy:.1e}  greatest way {way:.1e}  "
              f"mean {apart.mean():.1e} m{'  MISSED' if missed else ''}", flush=True)
        return int(missed)

    print(f"{name:<12} {slivers:<5} as drawn: {len(area)} blocks, {released:.6g} J released, "
          f"greatest way {farthest:.3g} m")
    for label, how in VARIANTS.items():
        kept = {key: how[key] for key in ("turn", "unit") if key in how}
        misses += line(label, end_of(placed(case, **how), folder, slivers, **kept)[0], True)
    for parts in (2, 4):
        line(f"dt/{parts}", end_of(placed(case), folder, slivers, TIME_STEP / parts)[0], False)
    return misses


def main():
    program, files = sys.argv[1], sys.argv[2:]
    with tempfile.TemporaryDirectory() as made:
        folder = Path(made)
        cases = {Path(file).stem: json.loads(Path(file).read_text()) for file in files}
        if not cases:
            cases = {name: drawn(program, folder, *how) for name, how in SLOPES.items()}
        misses = sum(compared(name, case, folder, slivers)
                     for name, case in cases.items() for slivers in ("glue", "keep"))
    print(f"{misses} missed")
    return 1 if misses else 0


if __name__ == "__main__":
    sys.exit(main())
