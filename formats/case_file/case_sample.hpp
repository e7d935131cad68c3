// Holds a small case file, which `keyblock formats keyblock-case` prints.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock::formats {

inline constexpr const char* kCaseSample = R"({
 "keyblock": 1,
 "units": {"length": "m", "mass": "kg", "time": "s"},
 "blocks": {
  "blocks": [
   {"material": 1, "outer": [[0, 0, 1], [4, 0, 1], [4, 1, 1], [0, 1, 1]]},
   {"material": 1, "outer": [[1, 1, 1], [2, 1, 1], [2, 2, 1], [1, 2, 1]]}
  ],
  "fixed_points": [[0.5, 0.5, 1], [3.5, 0.5, 1]],
  "measured_points": [[1.5, 1.5, 2]]
 },
 "analysis": {
  "velocity_carry_over": 1,
  "step_count": 100,
  "time_step": 0.001,
  "allowed_displacement_ratio": 0.01,
  "block_materials": [{"density": 2600, "unit_weight": 25506, "youngs_modulus": 5e9, "poissons_ratio": 0.25}],
  "joint_materials": [{"friction_angle_deg": 30}]
 },
 "run": {"profile": "standard"}
}
)";

}  // namespace keyblock::formats
