"""Deflection of a clamped NMM beam over the side of its mesh.

    python3 examples/python/beam_study.py [SMALLEST_SIDE]

Reference: theory of slender beams under their weight, w l⁴/(8 E' I), E' = E/(1 - ν²), with shear w l²/(2 k G A), k = 5/6.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import keyblock as kb

rock = {"name": "rock", "density": 2350, "youngs_modulus": 14.7e9, "poissons_ratio": 0.2}
beam = kb.read(kb.new("beam", "beam.json", force=True)).with_value("/analysis/block_materials/0", rock)
e, nu, w, length, height = rock["youngs_modulus"], rock["poissons_ratio"], rock["density"] * 9.81, 10, 1
theory = w * length**4 / (8 * e / (1 - nu**2) * height**3 / 12) + w * length**2 / (2 * 5 / 6 * e / (2 + 2 * nu) * height)
# %%
smallest = float(sys.argv[1]) if len(sys.argv) > 1 else 0.05
table = kb.sweep(beam, {"/covers/mesh/side": [s for s in (1, 0.5, 0.25, 0.1, 0.05) if s >= smallest]},
                 out=lambda run: {"tip": run.frame().point_displacement[0, 1], "unknowns": run.plan.unknowns})
for row in table:
    row["error"] = abs(row["tip"]) / theory - 1
print(table)
