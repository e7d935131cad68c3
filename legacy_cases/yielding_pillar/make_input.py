# Writes the inputs and expected values of this case: python3 make_input.py
# SPDX-License-Identifier: GPL-3.0-or-later
import json
import math
import os

E, NU, COHESION, PHI, HEIGHT, SHORTENED, STEPS = 1e4, 0.3, 10.0, 20.0, 1.0, 0.01, 20
PLATE = 1e6


def compressive(cohesion, phi):
    return 2 * cohesion * math.tan(math.radians(45 + phi / 2))


def case(on_covers, dilation):
    blocks = [{"material": 2, "outer": [[-1, -1, 1], [2, -1, 1], [2, 0, 1], [-1, 0, 1]]},
              {"material": 1, "outer": [[0, 0, 1], [1, 0, 1], [1, HEIGHT, 1], [0, HEIGHT, 1]]},
              {"material": 2, "outer": [[-1, HEIGHT, 1], [2, HEIGHT, 1], [2, 2, 1], [-1, 2, 1]]}]
    motion = [[0, 0, 0], [STEPS, 0, -SHORTENED]]
    pillar = {"density": 1, "unit_weight": 0, "youngs_modulus": E, "poissons_ratio": NU,
              "strength": {"cohesion": COHESION, "friction_deg": PHI, "dilation_deg": dilation}}
    plate = {"density": 1, "unit_weight": 0, "youngs_modulus": PLATE, "poissons_ratio": NU}
    made = {"keyblock": 1,
            "blocks": {"blocks": blocks, "fixed_points": [[-0.9, -0.5, 1], [1.9, -0.5, 1], [-0.9, 1.5, 3], [1.9, 1.5, 3]],
                       "measured_points": [[0.5, 0.5, 2], [1, 0.5, 2]]},
            "analysis": {"velocity_carry_over": 0, "step_count": STEPS, "time_step": 1, "allowed_displacement_ratio": 1,
                         "plane_strain": True, "fixed_point_motions": [[], [], motion, motion],
                         "block_materials": [pillar, plate], "joint_materials": [{"friction_angle_deg": 0}]}}
    if on_covers:
        made["covers"] = {"mesh": {"side": 0.35, "materials": [[1]]}}
    return made


def stress_on_covers(dilation):
    """Cauchy stress under logarithmic strain: that of the law over J; plates and contacts take none of the way."""
    strength = compressive(COHESION, PHI)
    axial = math.log(1 - SHORTENED / HEIGHT)
    elastic = -strength * (1 - NU * NU) / E, strength * NU * (1 + NU) / E
    plastic = axial - elastic[0]
    flow = (1 + math.sin(math.radians(dilation))) / (1 - math.sin(math.radians(dilation)))
    volume = sum(elastic) + plastic * (1 - flow)
    return -strength / math.exp(volume)


def write(name, about, on_covers, dilation, rows):
    os.makedirs(name, exist_ok=True)
    with open(f"{name}/{name}.json", "w") as file:
        json.dump(case(on_covers, dilation), file, indent=1)
        file.write("\n")
    with open(f"{name}/case.json", "w") as file:
        json.dump({"about": about, "legacy": "not run: a strength is read by profile standard"}, file, indent=1)
        file.write("\n")
    with open(f"{name}/expected.csv", "w") as file:
        file.write("quantity,block,time,value,tolerance,tolerance_reason,source,judged\n")
        for quantity, number, value, tolerance, reason, source in rows:
            file.write(f"{quantity},{number},{STEPS},{value:.12g},{tolerance:.6g},{reason},{source},standard\n")


COULOMB = "2 c tan(45 + phi/2): Coulomb 1776"
strength = compressive(COHESION, PHI)
for suffix, dilation, how in (("", PHI, ""), ("_psi_0", 0.0, ", flow without dilation")):
    write("pressed_block" + suffix, "a block of rock that yields between two plates" + how, False, dilation,
          [("syy", 2, -strength, 1e-6 * strength, "asked for: 1e-6", COULOMB),
           ("sxx", 2, 0, 1e-6 * strength, "asked for: 1e-6 of the strength", "free sides"),
           ("szz", 2, -NU * strength, 1e-6 * strength, "asked for: 1e-6 of the strength",
            "nu syy: the flow has no part across the plane")])
    write("pressed_on_covers" + suffix, "the same pillar on covers" + how, True, dilation,
          [("point_syy", 1, stress_on_covers(dilation), 1e-3 * strength, "plates and contacts are not rigid: 1e-3",
            COULOMB + " over J of logarithmic strain"),
           ("point_sxx", 1, 0, 1e-3 * strength, "asked for: 1e-3 of the strength", "free sides")])
