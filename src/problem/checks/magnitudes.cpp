// Tests, in one pass, all numbers that a calculation uses from a problem.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/checks/magnitudes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/box.hpp"
#include "problem/checks/shared_ground.hpp"

namespace keyblock {
namespace {

class Limits {
 public:
  std::vector<InputError> take() { return std::move(errors_); }

  void look_at(const std::monostate&) {}

  void look_at(const Drawing& drawing) {
    for (const JointLine& line : drawing.joints) {
      if (length(line.place, "the line", line.segment)) break;
      extent_.add(line.segment.start);
      extent_.add(line.segment.end);
    }
    for (const BoltLine& bolt : drawing.bolts) {
      length(bolt.place, "the bolt", bolt.segment);
      quantities(bolt.place, "of the bolt",
                 {{"stiffness", bolt.stiffness}, {"strength", bolt.strength}, {"pretension", bolt.pretension}});
    }
    for (const MaterialLine& line : drawing.material_lines) length(line.place, "the material line", line.segment);
    for (const FixedLine& line : drawing.fixed_lines) length(line.place, "the fixed line", line.segment);
    for (const auto* points : {&drawing.loading_points, &drawing.measured_points, &drawing.hole_points})
      for (const MarkedPoint& point : *points) length(point.place, "the point", point.position);
    extent(drawing.joints.empty() ? drawing.place : drawing.joints.front().place);
  }

  void look_at(const Blocks& blocks) {
    for (std::size_t i = 0; i < blocks.blocks.size(); ++i)
      if (!block(blocks.blocks[i], fmt::format("block {}", i + 1), place_of(blocks.blocks[i], blocks))) break;
    for (const BlockBolt& bolt : blocks.bolts) {
      length(place_of(bolt, blocks), "the bolt", bolt.segment);
      quantities(place_of(bolt, blocks), "of the bolt",
                 {{"stiffness", bolt.stiffness}, {"strength", bolt.strength}, {"pretension", bolt.pretension}});
    }
    points(blocks);
    extent(blocks.blocks.empty() ? blocks.place : place_of(blocks.blocks.front(), blocks));
  }

  void look_at(const Cover& cover) {
    for (const auto* list : {&cover.vertices, &cover.nodes})
      for (Point p : *list) {
        if (length(cover.place, list == &cover.nodes ? "a node" : "a vertex", p)) break;
        extent_.add(p);
      }
    points(cover);
    extent(cover.place);
  }

  void look_at(const Analysis& analysis) {
    not_zero(or_file(analysis.time_step_place, analysis), "the time step", analysis.time_step);
    not_zero(analysis.place, "the allowed displacement ratio", analysis.allowed_displacement_ratio);
    quantities(analysis.place, "of the analysis",
               {{"penalty factor", analysis.penalty_factor},
                {"contact stiffness", analysis.contact_penalty.value_or(0)},
                {"gravity", analysis.gravity.value_or(0)}});
    for (const BlockMaterial& material : analysis.block_materials) look_at(material, or_file(material.place, analysis));
    for (const JointMaterial& joint : analysis.joint_materials)
      quantities(or_file(joint.place, analysis), "of the joint material",
                 {{"cohesion", joint.cohesion}, {"tensile strength", joint.tensile_strength}});
    for (const BoltProperties& bolt : analysis.bolt_properties)
      quantities(analysis.place, "of a bolt type",
                 {{"stiffness", bolt.stiffness}, {"strength", bolt.strength}, {"pretension", bolt.pretension}});
    for (const TimeCurve& curve : analysis.point_loads) look_at(curve, "the load", kGreatestQuantity, analysis);
    for (const TimeCurve& curve : analysis.fixed_point_motions)
      look_at(curve, "the displacement", kGreatestLength, analysis);
    look_at(analysis.body_acceleration, "the acceleration", kGreatestQuantity, analysis);
  }

 private:
  struct Named {
    const char* name;
    double value;
  };

  static const Place& or_file(const Place& place, const Analysis& analysis) {
    return place.file.text().empty() ? analysis.place : place;
  }

  /// Returns true if the value is refused.
  bool refuse_beyond(double limit, const Place& place, const std::string& what, double value) {
    if (std::abs(value) <= limit) return false;
    errors_.emplace_back(place, fmt::format("expected {} from {:g} to {:g}, found {:g}", what, -limit, limit, value));
    return true;
  }

  void quantities(const Place& place, const char* whose, std::initializer_list<Named> all) {
    for (const auto& [name, value] : all)
      if (refuse_beyond(kGreatestQuantity, place, fmt::format("the {} {}", name, whose), value)) return;
  }

  /// A value of 0 is refused by the reader.
  void not_zero(const Place& place, const char* what, double value) {
    if (value == 0 || (value <= kGreatestQuantity && value >= 1 / kGreatestQuantity)) return;
    errors_.emplace_back(place, fmt::format("expected {} from {:g} to {:g}, found {:g}", what, 1 / kGreatestQuantity,
                                            kGreatestQuantity, value));
  }

  bool length(const Place& place, const char* what, Point p) {
    const double farthest = std::abs(p.x) > std::abs(p.y) ? p.x : p.y;
    return refuse_beyond(kGreatestLength, place, fmt::format("coordinates of {}", what), farthest);
  }

  bool length(const Place& place, const char* what, const Segment& s) {
    return length(place, what, s.start) || length(place, what, s.end);
  }

  /// Returns false if the block is refused.
  bool block(const BlockPolygon& block, const std::string& name, const Place& place) {
    const auto is_fine = [&](const BlockLoop& loop) {
      for (const BlockVertex& vertex : loop) {
        if (length(place, name.c_str(), vertex.position)) return false;
        extent_.add(vertex.position);
      }
      return true;
    };
    return is_fine(block.outer) && std::ranges::all_of(block.holes, is_fine);
  }

  template <class Geometry>
  void points(const Geometry& geometry) {
    for (const auto* list : {&geometry.fixed_points, &geometry.loading_points, &geometry.measured_points})
      for (const auto& point : *list) length(point.place, "the point", point.position);
  }

  void extent(const Place& place) {
    if (!errors_.empty() || !(extent_.low.x <= extent_.high.x)) return;
    const double size = std::max(extent_.size().x, extent_.size().y);
    if (size == 0 || size >= 1 / kGreatestLength) return;
    errors_.emplace_back(place, fmt::format("expected a geometry that extends over {:g} at least, found {:g}",
                                            1 / kGreatestLength, size));
  }

  void look_at(const BlockMaterial& m, const Place& place) {
    not_zero(place, "the density of the block material", m.density);
    not_zero(place, "the modulus of elasticity of the block material", m.youngs_modulus);
    quantities(place, "of the block material",
               {{"unit weight", m.unit_weight},
                {"damping", m.damping},
                {"initial stress", m.initial_stress.xx},
                {"initial stress", m.initial_stress.yy},
                {"initial stress", m.initial_stress.xy},
                {"initial stress", m.initial_stress.zz},
                {"gradient of stress", m.stress_gradient.zz},
                {"gradient of stress", m.stress_gradient.xx},
                {"gradient of stress", m.stress_gradient.yy},
                {"gradient of stress", m.stress_gradient.xy},
                {"velocity", m.initial_velocity.x},
                {"velocity", m.initial_velocity.y},
                {"rate of rotation", m.initial_velocity.rotation},
                {"horizontal force", m.horizontal_force}});
  }

  void look_at(const TimeCurve& curve, const char* noun, double limit, const Analysis& analysis) {
    for (Point value : curve.values)
      for (const double part : {value.x, value.y})
        if (refuse_beyond(limit, or_file(curve.place, analysis), noun, part)) return;
  }

  std::vector<InputError> errors_;
  Box extent_;
};

}  // namespace

std::vector<InputError> immeasurable(const Problem& problem) {
  Limits limits;
  std::visit([&](const auto& geometry) { limits.look_at(geometry); }, problem.geometry);
  if (problem.analysis) limits.look_at(*problem.analysis);
  return limits.take();
}

}  // namespace keyblock
