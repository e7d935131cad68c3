// Compares the faces that lie side by side at the start with each other and with the bonds of the first step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/facing_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/sentences/sentences.hpp"
#include "contact/rows/gap.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/touch_search.hpp"

namespace keyblock {
namespace {

// Faces farther apart than this fraction of block size are not meant to touch.
constexpr double kSideBySide = 1e-2;
// Sine of the angle up to which parts of an edge lie on one line.
constexpr double kInLine = 1e-6;

bool is_like(const JointMaterial& a, const JointMaterial& b) {
  return a.friction_angle_deg == b.friction_angle_deg && a.cohesion == b.cohesion &&
         a.tensile_strength == b.tensile_strength;
}

// Returns the number of a joint material with strength that faces have; negative without any.
int with_strength(const Model& model) {
  for (const Vertex& vertex : model.vertices)
    if (!vertex.is_inner && model.joint_material(vertex.joint_material).has_strength()) return vertex.joint_material;
  return -1;
}

bool may_differ(const Model& model) {
  return std::ranges::any_of(model.joint_materials, [&](const JointMaterial& joint) {
    return !is_like(joint, model.joint_materials.front());
  });
}

/// Some pairs of faces, and the first place found.
struct FacePairs {
  std::set<std::pair<VertexIndex, VertexIndex>> faces;
  Touch first;
  double widest = 0;  ///< distance

  void add(const Touch& touch, double gap) {
    if (faces.empty()) first = touch;
    faces.insert({touch.facing.lower, touch.facing.upper});
    widest = std::max(widest, std::abs(gap));
  }
  std::string counted() const {
    return faces.size() == 1 ? "a pair of faces" : fmt::format("{} pairs of faces", faces.size());
  }
};

class FacingFaces {
 public:
  explicit FacingFaces(const Scene& asked) : scene_(standard_scene(asked)), motion_(start_motion(scene_)) {
    scales_ = scales_at(scene_, motion_, 0);
    motion_.bonds = bonds_at(scene_, motion_, scales_);
    vertices_ = vertices_at(scene_.model, scene_.reference, motion_.q);
    std::set<std::pair<VertexIndex, VertexIndex>> bonded;
    for (const auto& [facing, bond] : motion_.bonds) bonded.insert({facing.lower, facing.upper});
    for (const Touch& touch : meeting_touches(scene_, motion_, scales_, kSideBySide * scales_.size)) {
      if (!touch.facing.lower || touch.stretch <= 0) continue;
      const double gap = gap_of(touch, vertices_);
      if (has_strength(scene_, touch) && !bonded.contains({touch.facing.lower, touch.facing.upper}))
        apart_.add(touch, gap);
      if (has_two_materials(touch)) differing_.add(touch, gap);
    }
  }

  Warnings warnings(const Place& place) const {
    Warnings found;
    const int material = with_strength(scene_.model);
    if (!apart_.faces.empty())
      found.push_back(warning_of(of_apart(), place));
    else if (material >= 0 && motion_.bonds.empty())
      found.push_back(warning_of({"strength_without_bond:nowhere", {strengths(material)}}, place));
    if (!differing_.faces.empty()) found.push_back(warning_of(of_differing(), place));
    return found;
  }

 private:
  // Returns the end of the edge part that begins at a vertex; its joint material is that of the part.
  VertexIndex end_of(VertexIndex start) const { return scene_.model.vertices[start].next; }

  // Looks at all parts of the other face, because the touch names the part of one face only.
  bool has_two_materials(const Touch& touch) const {
    const Model& model = scene_.model;
    const JointMaterial& joint = model.joint_material(touch.joint_material);
    const ElementIndex own = model.vertices[touch.start].element;
    const bool is_lower = model.vertices[touch.facing.lower].element == own;
    const VertexIndex start = is_lower ? touch.facing.upper : touch.facing.lower;
    const Point along = vertices_[end_of(start)] - vertices_[start];
    for (VertexIndex from = start;; from = end_of(from)) {
      const Point part = vertices_[end_of(from)] - vertices_[from];
      if (from != start && std::abs(cross(along, part)) > kInLine * length(along) * length(part)) return true;
      if (is_like(joint, model.joint_material(model.vertices[end_of(from)].joint_material))) return false;
    }
  }

  std::vector<std::pair<std::string, double>> strengths(int number) const {
    const JointMaterial& joint = scene_.model.joint_material(number);
    return {{"joint_material", number + 1}, {"cohesion", joint.cohesion}, {"tensile_strength", joint.tensile_strength}};
  }

  /// Returns the first pair of blocks, its place, and the number of pairs.
  Facts facts_of(const FacePairs& pairs, std::vector<std::pair<std::string, double>> numbers) const {
    const auto number = [&](VertexIndex vertex) {
      return scene_.model.number_of(scene_.model.vertices[vertex].element);
    };
    const Point at = point_of(pairs.first, vertices_);
    numbers.emplace_back("count", pairs.faces.size());
    return {std::move(numbers),
            {{"pairs", pairs.counted()}},
            {number(pairs.first.vertex), number(pairs.first.start)},
            {{at.x, at.y}}};
  }

  Finding of_apart() const {
    Facts facts = facts_of(apart_, strengths(apart_.first.joint_material));
    facts.numbers.emplace_back("apart", apart_.widest);
    facts.numbers.emplace_back("limit", tolerances::of_gaps::kDrawnTogether * scales_.size);
    facts.texts.emplace_back("are", apart_.faces.size() == 1 ? "is" : "are");
    return {"strength_without_bond", std::move(facts)};
  }

  Finding of_differing() const {
    Facts facts = facts_of(differing_, {{"joint_material", differing_.first.joint_material + 1}});
    facts.texts.emplace_back("have", differing_.faces.size() == 1 ? "has" : "have");
    return {"joint_materials_differ", std::move(facts)};
  }

  StandardScene scene_;
  Motion motion_;
  Scales scales_;
  Table<VertexIndex, Point> vertices_;
  FacePairs apart_;      ///< with strength, without a bond
  FacePairs differing_;  ///< with two joint materials
};

}  // namespace

Warnings facing_faces(const Scene& scene, const Place& place) {
  const bool is_checked = scene.settings.dynamics == Dynamics::standard && !scene.is_untouched;
  if (!is_checked || (with_strength(scene.model) < 0 && !may_differ(scene.model))) return {};
  return FacingFaces(scene).warnings(place);
}

}  // namespace keyblock
