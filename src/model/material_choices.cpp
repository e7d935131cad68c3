// Looks up the value of one material, or of any.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/material_choices.hpp"

namespace keyblock {

double restitution_of(const Settings& settings, int joint_material) {
  return settings.standard.restitution.of(joint_material);
}

Enforcement enforcement_of(const Settings& settings, int joint_material) {
  return settings.standard.enforcement.of(joint_material);
}

bool has_enforcement(const Settings& settings, const Model& model, Enforcement enforcement) {
  for (int i = 0; i < static_cast<int>(model.joint_materials.size()); ++i)
    if (enforcement_of(settings, i) == enforcement) return true;
  return false;
}

bool is_static(const Settings& settings, const Model& model) {
  for (int i = 0; i < static_cast<int>(model.block_materials.size()); ++i)
    if (settings.velocity_carry_over.of(i) != 0) return false;
  return true;
}

}  // namespace keyblock
