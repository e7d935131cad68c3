"""Sweeps the friction angle of a sliding block in child processes and compares with theory.

    python3 examples/python/sliding_angles.py [STEP_OF_DEGREES]

Purpose: a sweep in which a crash costs one row, not the script. Reference: s = g t²/2 (sin 30° - cos 30° tan φ).
SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import keyblock as kb
import matplotlib.pyplot as plt
import numpy as np

base = kb.read("legacy_cases/sliding_block/a30_p20")
angle = "/analysis/joint_materials/0/friction_angle_deg"
# %%
degrees = range(10, 30, int(sys.argv[1]) if len(sys.argv) > 1 else 1)
table = kb.sweep(base, {angle: degrees}, out=lambda run: np.hypot(*run.frame().displacement[1]), profile="standard",
                 time_limit=60)
# %%
theory = 0.5 * 9.81 * (np.sin(np.pi / 6) - np.cos(np.pi / 6) * np.tan(np.radians(table[angle])))
plt.plot(table[angle], theory, "-", table[angle], table["out"], "o")
plt.savefig("sliding_angles.svg")
print(table)
print(f"largest error: {max(abs(table['out'] / theory - 1)):.1e}")
