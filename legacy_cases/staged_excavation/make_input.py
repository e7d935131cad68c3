#!/usr/bin/env python3
# Writes the four inputs of this case and what they must give; run it here. Closed forms, see README.md.
# SPDX-License-Identifier: GPL-3.0-or-later
import json
import os

DENSITY, GRAVITY = 2500.0, 9.81
GAMMA = DENSITY * GRAVITY
E, NU = 5e10, 0.0
STIFFNESS = 1e6  # of each of two bolts
STEP = 0.01

ANALYSIS = {
    "velocity_carry_over": 0, "step_count": 1, "time_step": STEP, "allowed_displacement_ratio": 0.1,
    "gravity": GRAVITY,
    "block_materials": [{"density": DENSITY, "unit_weight": GAMMA, "youngs_modulus": E, "poissons_ratio": NU}],
    "joint_materials": [{"friction_angle_deg": 0, "cohesion": 0, "tensile_strength": 0}]}


def rectangle(x0, y0, x1, y1):
    return {"material": 1, "outer": [[x0, y0, 1], [x1, y0, 1], [x1, y1, 1], [x0, y1, 1]]}


def box(x0, y0, x1, y1):
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def write(name, case, about, rows):
    os.makedirs(name, exist_ok=True)
    with open(f"{name}/{name}.json", "w", encoding="utf-8") as file:
        json.dump({"keyblock": 1, **case}, file, indent=1)
        file.write("\n")
    with open(f"{name}/case.json", "w", encoding="utf-8") as file:
        json.dump({"about": about, "legacy": "not run: the old program knows no stages"}, file, indent=1)
        file.write("\n")
    with open(f"{name}/expected.csv", "w", encoding="utf-8") as file:
        file.write("quantity,block,time,value,tolerance,tolerance_reason,source,judged\n")
        for quantity, number, time, value, tolerance, reason, source in rows:
            file.write(f'{quantity},{number},{time:.6g},{value!r},{tolerance!r},"{reason}","{source}",standard\n')


# A roof block of 2 m by 1 m on a pillar of 3 m between held walls, two bolts to the held rock above it.
ROOF = [rectangle(-4, -1, 4, 0), rectangle(-4, 0, -1, 4), rectangle(1, 0, 4, 4), rectangle(-4, 5, 4, 6),
        rectangle(-1, 0, 1, 3), rectangle(-1, 3, 1, 4)]
BOLTS = [[-0.5, 3.5, -0.5, 5.5, STIFFNESS, 0, 0, 1], [0.5, 3.5, 0.5, 5.5, STIFFNESS, 0, 0, 1]]
STAGES = [{"name": "in situ", "steps": 2},
          {"name": "bolts", "steps": 2, "bolts": BOLTS},
          {"name": "heading", "steps": 2, "excavations": [{"outline": box(-1, 1.5, 1, 3), "joint_material": 1}]},
          {"name": "bench", "steps": 2, "excavations": [{"outline": box(-1, 0, 1, 1.5), "joint_material": 1}]},
          {"name": "bolts out", "duration": 0.3, "removed_bolts": [[1], [2]],
           "set": {"velocity_carry_over": "1", "motion": "dynamic"}}]
WEIGHT = GAMMA * 2
SINK = WEIGHT / (2 * STIFFNESS)
SETTLED = (GAMMA * 1 * 3 + GAMMA * 3 * 3 / 2) / E  # of the pillar, before the bolts
FALL = GRAVITY * 0.3 ** 2 / 2


def roof_rows(quantity, number):
    reason = "settlement of the pillar before the bolts, 6e-6 m, and the give of the roof block itself"
    return [(quantity, number, 0.06, -SINK - SETTLED, 1e-5, reason, "closed form: W/(2k)"),
            (quantity, number, 0.08, -SINK - SETTLED, 1e-5, reason, "closed form: W/(2k); the bench bears nothing"),
            (quantity, number, 0.38, -SINK - SETTLED - FALL, 2e-5, reason, "closed form: W/(2k) + g t^2/2")]


fixed = [[-3, -0.5, 1], [3, -0.5, 1], [-3, 1, 2], [-3, 3, 2], [3, 1, 3], [3, 3, 3], [-3, 5.5, 4], [3, 5.5, 4]]
write("roof_block",
      {"blocks": {"blocks": ROOF, "fixed_points": fixed, "measured_points": [[0, 3.5, 6]]},
       "analysis": ANALYSIS, "stages": STAGES},
      "A tunnel dug in two parts below a roof block that bolts hold; without them it falls.", roof_rows("dy", 6))

held = [{"along": along, "held": "both"} for along in
        ([[-4, -1], [4, -1]], [[-4, 0], [-4, 4]], [[4, 0], [4, 4]], [[-4, 6], [4, 6]])]
write("roof_block_on_covers",
      {"blocks": {"blocks": ROOF, "measured_points": [[0, 3.5, 6]]}, "analysis": ANALYSIS,
       "covers": {"functions": "linear", "mesh": {"side": 1.3}, "displacements": held}, "stages": STAGES},
      "The same with all rock on covers.", roof_rows("point_dy", 1))

# Four blocks of 2 m by 1 m, of which one after the other goes.
COLUMN = [rectangle(-1, -1, 3, 0)] + [rectangle(0, i, 2, i + 1) for i in range(4)]
COLUMN_STAGES = [{"name": "all", "steps": 2}] + [
    {"name": f"{i} left", "steps": 2, "excavations": [{"outline": box(-0.5, i, 2.5, 5), "joint_material": 1}]}
    for i in (3, 2, 1)]


def stress_rows(quantity, number, share, reason):
    rows = []
    for stage, left in enumerate((4, 3, 2, 1)):
        stress = GAMMA * (left - 0.5)
        rows.append((quantity, number, STEP * 2 * (stage + 1), -stress, (share if left > 1 else 1e-5) * stress, reason,
                     "statics: the weight of the lowest block's upper half and of all above"))
    return rows


write("column",
      {"blocks": {"blocks": COLUMN, "fixed_points": [[-0.5, -0.5, 1], [2.5, -0.5, 1]]}, "analysis": ANALYSIS,
       "stages": COLUMN_STAGES},
      "A column whose blocks are taken from the top, one a stage.", stress_rows("syy", 2, 1e-5, "weight acts on the present area"))

write("column_on_covers",
      {"blocks": {"blocks": COLUMN[1:], "measured_points": [[1, 0.5, 1]]}, "analysis": ANALYSIS,
       "covers": {"functions": "linear", "mesh": {"side": 0.6},
                  "displacements": [{"along": [[0, 0], [2, 0]], "held": "both"}]},
       "stages": COLUMN_STAGES},
      "The same with the blocks on covers, the lowest held along its base.", stress_rows("point_syy", 1, 0.03,
                  "contact forces act at points of the faces, not spread over them: 3 % at half a block's height below; "
                  "none where nothing stands on it"))
