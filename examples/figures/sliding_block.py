"""Displacement of a block on a slope over time for several friction angles, after MacLaughlin (1997).

    python3 examples/figures/sliding_block.py [NUMBER_OF_ANGLES]

Figure: displacement over time on a slope of 30 degrees against s = g t² (sin a - cos a tan phi) / 2. MacLaughlin and Doolin
(2006) collect the studies that validate DDA by this figure. Cases: legacy_cases/sliding_block.

- M. M. MacLaughlin: Discontinuous deformation analysis of the kinematics of landslides. PhD thesis, Berkeley (1997).
- M. M. MacLaughlin, D. M. Doolin: Review of validation of the discontinuous deformation analysis (DDA) method. IJNAMG 30
  (2006).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import keyblock as kb
import matplotlib.pyplot as plt
import numpy as np

base = kb.read("legacy_cases/sliding_block/a30_p00")
angles = [0, 10, 20, 25, 28][:int(sys.argv[1]) if len(sys.argv) > 1 else None]
slope, g = np.radians(30), 9.81

figure, axes = plt.subplots(figsize=(7, 4))
largest = 0.0
for angle in angles:
    case = base.with_value("/analysis/joint_materials/*/friction_angle_deg", angle)
    run = kb.Run(case, profile="standard", settings={"time_step": 0.01, "steps": 100}, history=["block:2"])
    run.go_on()
    (name,) = run.histories()
    way = run.history(name)
    computed = np.hypot(way["displacement_x"], way["displacement_y"])
    theory = g * way["time"] ** 2 / 2 * max(0.0, np.sin(slope) - np.cos(slope) * np.tan(np.radians(angle)))
    largest = max(largest, abs(computed - theory).max())
    axes.plot(way["time"], theory, "k-", linewidth=0.8)
    axes.plot(way["time"][::10], computed[::10], "o", mfc="none", label=f"φ = {angle}°")
print(f"largest difference {largest:.1e} m")
axes.set(xlabel="time [s]", ylabel="displacement [m]", title="Block on a slope of 30°; lines: theory")
axes.legend()
figure.savefig("sliding_block.svg")
