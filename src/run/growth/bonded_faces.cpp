// Checks the joint materials of the edges that end at tips; see bonded_faces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/growth/bonded_faces.hpp"

#include <fmt/format.h>

#include <string>

#include "base/words/plain_number.hpp"
#include "model/continuum.hpp"

namespace keyblock {
namespace {

/// Returns the joint material of the edges that begin at a tip, along one face of its crack; otherwise -1.
int joint_material_at(const Manifold& manifold, const CrackTip& tip) {
  for (const BoundaryEdge& edge : manifold.boundary_edges) {
    const ElementCorner& corner = manifold.corners[static_cast<std::size_t>(edge.corner)];
    if (corner.position == tip.at) return corner.joint_material;
  }
  return -1;
}

}  // namespace

Warnings bonded_crack_faces(const Scene& scene, const Place& place) {
  const Model& model = scene.model;
  if (scene.is_untouched || !model.continuum) return {};
  const auto is_bonded = [&](int number) {
    if (number < 0 || static_cast<std::size_t>(number) >= model.joint_materials.size()) return false;
    return model.joint_material(number).has_strength();
  };
  const auto warning = [&](const std::string& which, int number) {
    const JointMaterial& joint = model.joint_material(number);
    return Warnings{{"bonded_crack_faces", place,
                     fmt::format("the faces of {} are bonded: joint material {} has the cohesion {} and the tensile "
                                 "strength {}: K is that of bonded faces as long as the bonds hold; a joint material "
                                 "without both leaves the crack open",
                                 which, number + 1, plain(joint.cohesion), plain(joint.tensile_strength))}};
  };
  for (const CrackTip& tip : model.continuum->manifold.tips)
    if (const int number = joint_material_at(model.continuum->manifold, tip); is_bonded(number))
      return warning(fmt::format("the crack that ends at {}, {}", plain(tip.at.x), plain(tip.at.y)), number);
  const int of_new = CrackPlan{}.joint_material;
  return scene.growth && is_bonded(of_new) ? warning("cracks that start", of_new) : Warnings{};
}

}  // namespace keyblock
