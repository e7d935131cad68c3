#!/usr/bin/env python3
"""Writes the case files of this folder: a square metre on covers upon a held block, on a slope of 30 degrees, friction 20 degrees."""
import json
import math
from pathlib import Path

ANGLE = math.radians(30)


def turned(x, y):
    c, s = math.cos(-ANGLE), math.sin(-ANGLE)
    return [c * x - s * y, s * x + c * y]


def corners(low, high):
    (x0, y0), (x1, y1) = low, high
    return [turned(x, y) + [1] for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]


ROCK = {"density": 2600, "unit_weight": 2600 * 9.81, "youngs_modulus": 5e9, "poissons_ratio": 0.25}
CASE = {
    "keyblock": 1,
    "blocks": {
        "blocks": [
            {"material": 1, "outer": corners((0, -2), (20, 0))},
            {"material": 2, "outer": corners((1, 0), (2, 1))},
        ],
        "fixed_points": [turned(1, -1) + [1], turned(19, -1) + [1]],
        "measured_points": [turned(1.5, 0.5) + [2]],
    },
    "covers": {"functions": "derived", "mesh": {"half_rows": 2, "angle": 10, "materials": [[2]]}},
    "analysis": {
        "velocity_carry_over": 1,
        "step_count": 1000,
        "time_step": 0.001,
        "allowed_displacement_ratio": 0.01,
        "gravity": 9.81,
        "penalty_factor": 10,
        "block_materials": [ROCK, ROCK],
        "joint_materials": [{"friction_angle_deg": 20}],
    },
    "run": {"set": {"force_weight": "1"}},
}

if __name__ == "__main__":
    folder = Path(__file__).parent / "a30_p20"
    folder.mkdir(exist_ok=True)
    (folder / "a30_p20.json").write_text(json.dumps(CASE, indent=1) + "\n")
