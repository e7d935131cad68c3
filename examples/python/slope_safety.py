"""Factor of safety of a drawn slope (DXF), and probability of failure over random joint sets.

    python3 examples/python/slope_safety.py [NUMBER_OF_JOINT_SETS]

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import keyblock as kb

slope = kb.read("docs/quarry.dxf", "docs/bench.json", layers="docs/quarry_layers.csv")
with kb.Context(threads=2, time_limit=300, progress=True) as c:
    s = kb.factor_of_safety(slope, "joints", context=c)
print("quarry: stable at", s.stands, "unstable at", s.falls, *s.notes, sep="\n  ")

# %%
spec = {"slope": {"height": 10, "angle": 60, "toe": 5, "crest": 10, "base": 3},
        # base, back and front: a side without a fixed line is a free face, whose failure would be counted
        "fixed": [[-6, -2.98, 17, -2.98], [15.753, -4, 15.753, 11], [-4.98, -4, -4.98, 1]],
        "sets": [{"dip": 35, "spacing": 2, "trace": 100, "scatter": 0.2, "dip_scatter_deg": 3, "joint": 1},
                 {"dip": 118, "spacing": 3, "trace": 100, "scatter": 0.2, "dip_scatter_deg": 3, "joint": 2}]}
rock = kb.read("docs/bench.json").with_value("/analysis/joint_materials/*/friction_angle_deg", 36)
count = int(sys.argv[1]) if len(sys.argv) > 1 else 200
table = kb.sweep(rock, {"joints:/seed": range(1, count + 1)}, out=["fos"], joints=spec, time_limit=300)
table.write("slope_safety.csv")
# %%
known = [row for row in table if row["verdict"] in ("finished", "falls", "stands")]  # the others are undecided
below = sum(row["verdict"] == "falls" or row["verdict"] == "finished" and row["fos"] < 1 for row in known)
print(table, f"probability of failure: {below / max(1, len(known)):.2f} of {len(known)} joint sets, "
      f"{count - len(known)} undecided", sep="\n")
