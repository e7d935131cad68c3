"""Block that sticks and slips on a slope under a harmonic acceleration, after Goodman and Seed (1966).

    python3 examples/figures/sliding_velocity.py [SECONDS]

Figure: velocity down the slope over time against the equation of motion of a rigid block, s'' = g (sin a - cos a tan phi)
+ a(t) (cos a + sin a tan phi). Hatzor and Feinstein (2001) compared DDA with the same equation in such a figure. The case
is legacy_cases/newmark_sine/row_1: slope, friction and acceleration are read from it.

- R. E. Goodman, H. B. Seed: Earthquake-induced displacements in sand embankments. J. Soil Mech. Found. Div. 92 (1966).
- Y. H. Hatzor, A. Feinstein: The validity of dynamic block displacement prediction using DDA. IJRMMS 38 (2001).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import keyblock as kb
import matplotlib.pyplot as plt
import numpy as np

FOLDER = "legacy_cases/newmark_sine/row_1"
case = kb.read(FOLDER)
seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 4
run = kb.Run(case, profile="standard", settings={"steps": round(seconds / 1e-3), "time_step": 1e-3}, history=["block:2"])
block = run.plan.case.get("/blocks/blocks/1/outer")
(x0, y0, _), (x1, y1, _) = block[0], block[1]
slope = np.arctan2(y0 - y1, x1 - x0)  # the base of the block, down to the right
friction = np.tan(np.radians(case.get("/analysis/joint_materials/0/friction_angle_deg")))
run.go_on()
(name,) = run.histories()
slip = run.history(name)
computed = slip["velocity_x"] * np.cos(slope) - slip["velocity_y"] * np.sin(slope)

time, ax, ay = np.loadtxt(f"{FOLDER}/motion.csv", delimiter=",", skiprows=1).T
dt, v, t, theory = 2e-5, 0.0, 0.0, [0.0]
for _ in range(round(seconds / dt)):
    t += dt
    a, g = np.interp(t - dt / 2, time, ax), 9.81
    pull = g * np.sin(slope) + a * np.cos(slope)
    hold = max(0.0, g * np.cos(slope) - a * np.sin(slope)) * friction
    if v == 0 and abs(pull) <= hold:
        theory.append(0.0)
        continue
    new = v + dt * (pull - np.copysign(hold, v or pull))
    v = 0.0 if v * new < 0 else new
    theory.append(v)
exact = np.interp(slip["time"], dt * np.arange(len(theory)), theory)
print(f"largest velocity {exact.max():.3f} m/s, largest difference {abs(computed - exact).max():.1e} m/s")

figure, axes = plt.subplots(figsize=(7, 4))
axes.plot(slip["time"], exact, "k-", label="equation of motion")
axes.plot(slip["time"][::40], computed[::40], "o", mfc="none", label="Keyblock, 1 ms")
axes.set(xlabel="time [s]", ylabel="velocity down the slope [m/s]", title="Block on a slope under a sine")
axes.legend()
figure.savefig("sliding_velocity.svg")
