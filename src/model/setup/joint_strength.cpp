// Scales the tangent of the friction angle, the cohesion and the tensile strength.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/joint_strength.hpp"

#include <cmath>
#include <numbers>

namespace keyblock {

Model with_joint_strength(Model model, double factor) {
  if (factor == 1) return model;
  for (JointMaterial& joint : model.joint_materials) {
    joint.friction_angle_deg = std::atan(factor * joint.friction_tangent()) * 180 / std::numbers::pi;
    joint.cohesion *= factor;
    joint.tensile_strength *= factor;
  }
  return model;
}

}  // namespace keyblock
