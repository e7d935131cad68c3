// Compares the faces that lie side by side at the start with the bonds of the first step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/unbonded_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/words/plain_number.hpp"
#include "contact/rows/gap.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/touch_search.hpp"

namespace keyblock {
namespace {

// Faces farther apart than this fraction of block size are not meant to touch.
constexpr double kSideBySide = 1e-2;

using Faces = std::pair<VertexIndex, VertexIndex>;

Faces faces_of(const Facing& facing) {
  return {facing.lower, facing.upper};
}

/// Pairs of faces with strength that lie side by side without a bond.
struct Apart {
  std::set<Faces> faces;
  Touch first;
  Point place;
  double widest = 0;
};

Apart apart_in(const StandardScene& scene, const Motion& motion, const Scales& scales) {
  std::set<Faces> bonded;
  for (const auto& [facing, bond] : motion.bonds) bonded.insert(faces_of(facing));
  const auto vertices = vertices_at(scene.model, scene.reference, motion.q);
  Apart apart;
  for (const Touch& touch : meeting_touches(scene, motion, scales, kSideBySide * scales.size)) {
    if (!has_strength(scene, touch) || bonded.contains(faces_of(touch.facing))) continue;
    if (apart.faces.empty()) {
      apart.first = touch;
      apart.place = point_of(touch, vertices);
    }
    apart.faces.insert(faces_of(touch.facing));
    apart.widest = std::max(apart.widest, std::abs(gap_of(touch, vertices)));
  }
  return apart;
}

bool has_strength(const JointMaterial& joint) {
  return joint.cohesion > 0 || joint.tensile_strength > 0;
}

// Returns the number of a joint material with strength that faces have; negative without any.
int with_strength(const Model& model) {
  for (const Vertex& vertex : model.vertices)
    if (!vertex.is_inner && has_strength(model.joint_material(vertex.joint_material))) return vertex.joint_material;
  return -1;
}

std::string sentence(const StandardScene& scene, const Apart& apart, int material, double limit) {
  const auto strengths = [&](int number) {
    const JointMaterial& joint = scene.model.joint_material(number);
    return fmt::format("joint material {} has the cohesion {} and the tensile strength {}", number + 1,
                       plain(joint.cohesion), plain(joint.tensile_strength));
  };
  if (apart.faces.empty())
    return fmt::format("{}, but no two of its faces touch at the start: neither acts anywhere", strengths(material));
  const auto number = [&](VertexIndex vertex) { return scene.model.number_of(scene.model.vertices[vertex].element); };
  return fmt::format(
      "{}, but {} of its faces {} drawn up to {} apart, first blocks {} and {} near {}, {}: there neither acts; only "
      "faces drawn within {} of each other are bonded",
      strengths(apart.first.joint_material),
      apart.faces.size() == 1 ? "a pair" : fmt::format("{} pairs", apart.faces.size()),
      apart.faces.size() == 1 ? "is" : "are", plain(apart.widest, 3), number(apart.first.vertex),
      number(apart.first.start), plain(apart.place.x, 4), plain(apart.place.y, 4), plain(limit, 3));
}

}  // namespace

Warnings unbonded_faces(const Scene& asked, const Place& place) {
  if (asked.settings.dynamics != Dynamics::standard || asked.is_untouched) return {};
  const int material = with_strength(asked.model);
  if (material < 0) return {};
  const StandardScene scene = standard_scene(asked);
  Motion motion = start_motion(scene);
  const Scales scales = scales_at(scene, motion, 0);
  motion.bonds = bonds_at(scene, motion, scales);
  const Apart apart = apart_in(scene, motion, scales);
  if (apart.faces.empty() && !motion.bonds.empty()) return {};
  const double limit = tolerances::of_gaps::kDrawnTogether * scales.size;
  return {{"strength_without_bond", place, sentence(scene, apart, material, limit)}};
}

}  // namespace keyblock
