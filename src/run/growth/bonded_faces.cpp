// Checks the joint materials of the edges that end at tips; see bonded_faces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/growth/bonded_faces.hpp"

#include <array>
#include <utility>
#include <vector>

#include "base/sentences/sentences.hpp"
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
  const auto warning = [&](const char* form, int number, std::vector<std::array<double, 2>> tips) {
    const JointMaterial& joint = model.joint_material(number);
    Facts facts{
        {{"joint_material", number + 1}, {"cohesion", joint.cohesion}, {"tensile_strength", joint.tensile_strength}}};
    facts.points = std::move(tips);
    return Warnings{warning_of({form, std::move(facts)}, place)};
  };
  for (const CrackTip& tip : model.continuum->manifold.tips)
    if (const int number = joint_material_at(model.continuum->manifold, tip); is_bonded(number))
      return warning("bonded_crack_faces", number, {{tip.at.x, tip.at.y}});
  const int of_new = CrackPlan{}.joint_material;
  return scene.growth && is_bonded(of_new) ? warning("bonded_crack_faces:of_new", of_new, {}) : Warnings{};
}

}  // namespace keyblock
