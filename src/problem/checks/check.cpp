// Checks a problem: each function tests one aspect and returns its errors and warnings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/sentences/sentences.hpp"
#include "base/words/quoted_name.hpp"
#include "geometry/polygon.hpp"
#include "problem/checks/magnitudes.hpp"
#include "problem/checks/material_numbers.hpp"
#include "problem/checks/shared_ground.hpp"
#include "problem/ground_motion.hpp"

namespace keyblock {
namespace {

constexpr double kUsualEdgeNodeRatio = 0.1;  // files have 0.001 … 0.02; from here on the cutter removes whole blocks

bool is_point(const Segment& segment) {
  return segment.start == segment.end;
}

constexpr const char* kZeroLengthBolt = "a bolt without length has no direction and is left out";

Warnings zero_length_lines(const Drawing& drawing) {
  Warnings warnings;
  for (const JointLine& line : drawing.joints)
    if (is_point(line.segment)) warnings.push_back(warning_of({"zero_length_line:cuts_nothing"}, line.place));
  for (const BoltLine& bolt : drawing.bolts)
    if (is_point(bolt.segment)) warnings.push_back({"zero_length_bolt", bolt.place, kZeroLengthBolt});
  return warnings;
}

Warnings zero_length_bolts(const Blocks& blocks) {
  const auto has_no_length = [](const BlockBolt& bolt) { return is_point(bolt.segment); };
  const auto first = std::ranges::find_if(blocks.bolts, has_no_length);
  if (first == blocks.bolts.end()) return {};
  return {{"zero_length_bolt", place_of(*first, blocks), kZeroLengthBolt}};
}

Warnings unusual_ratio(const Drawing& drawing) {
  if (drawing.edge_node_ratio > 0 && drawing.edge_node_ratio < kUsualEdgeNodeRatio) return {};
  Facts facts{{{"ratio", drawing.edge_node_ratio}, {"most", kUsualEdgeNodeRatio}}};
  return {warning_of({"edge_node_ratio_unusual", std::move(facts)}, drawing.place)};
}

// Without an analysis, weight is to be expected.
bool has_weight(const std::optional<Analysis>& analysis) {
  if (!analysis || analysis->gravity) return !analysis || *analysis->gravity != 0;
  return std::ranges::any_of(analysis->block_materials, [](const BlockMaterial& m) { return m.unit_weight != 0; });
}

bool has_fixed(std::monostate) {
  return false;
}

bool has_fixed(const Drawing& drawing) {
  return !drawing.fixed_lines.empty();
}

template <class PointsGeometry>
bool has_fixed(const PointsGeometry& geometry) {
  return !geometry.fixed_points.empty();
}

Warnings no_fixed_points(const std::optional<Analysis>& analysis, const Place& place) {
  if (!has_weight(analysis))
    return {{"free_without_gravity", place, "there are no fixed points, and no gravity: the blocks are free"}};
  return {{"no_fixed_points", place, "there are no fixed points: the blocks have no support"}};
}

Warnings curves_and_points(const Analysis& analysis, std::size_t loading_points, const Place& place) {
  const std::size_t curves = analysis.point_loads.size();
  const Facts facts{{{"curves", curves}, {"loading_points", loading_points}}};
  if (curves > loading_points)
    return {warning_of({"surplus_load_curves", facts}, analysis.point_loads[loading_points].place)};
  if (curves < loading_points) return {warning_of({"loading_points_without_load", facts}, place)};
  return {};
}

template <class B>
std::vector<InputError> bolts_that_push(const std::vector<B>& bolts, auto place_of) {
  std::vector<InputError> errors;
  for (std::size_t i = 0; i < bolts.size(); ++i)
    if (!(bolts[i].stiffness >= 0))
      errors.emplace_back(place_of(bolts[i]),
                          fmt::format("expected a stiffness of at least 0 of bolt {} of {}{}, found {}", i + 1,
                                      bolts.size(), quoted_name(bolts[i].name.value_or({})), bolts[i].stiffness));
  return errors;
}

/// Returns one warning for all bolts that can never carry a force.
template <class B>
Warnings idle_bolts(const std::vector<B>& bolts, auto place_of) {
  const auto is_idle = [](const B& bolt) { return bolt.stiffness == 0 && bolt.pretension == 0; };
  const auto first = std::ranges::find_if(bolts, is_idle);
  if (first == bolts.end()) return {};
  const auto count = static_cast<std::size_t>(std::ranges::count_if(bolts, is_idle));
  Facts facts{{{"count", count}, {"bolts", bolts.size()}},
              {{"have", count == 1 ? "has" : "have"}, {"carry", count == 1 ? "carries" : "carry"}}};
  return {warning_of({"bolts_without_properties", std::move(facts)}, place_of(*first))};
}

std::vector<InputError> impossible_blocks(const Blocks& blocks) {
  std::vector<InputError> errors;
  for (std::size_t i = 0; i < blocks.blocks.size(); ++i)
    if (const double size = area(points_of(blocks.blocks[i].outer)); !(size > 0))
      errors.emplace_back(place_of(blocks.blocks[i], blocks),
                          fmt::format("expected block {} of {} counter-clockwise with an area, found area {}", i + 1,
                                      blocks.blocks.size(), size));
  return errors;
}

std::vector<InputError> impossible_elements(const Cover& cover) {
  std::vector<InputError> errors;
  for (std::size_t i = 0; i < cover.elements.size(); ++i)
    if (const double size = area(cover.polygon(cover.elements[i])); !(size > 0))
      errors.emplace_back(cover.elements[i].place.line > 0 ? cover.elements[i].place : cover.place,
                          fmt::format("expected element {} of {} counter-clockwise with an area, found area {}", i + 1,
                                      cover.elements.size(), size));
  return errors;
}

/// Holds the problem while it is checked and corrected.
class Checker {
 public:
  explicit Checker(Problem problem) : checked_{std::move(problem), {}, {}} {}

  Checked check() {
    fail(immeasurable(checked_.problem));
    if (!checked_.errors.empty()) return std::move(checked_);
    fail(crossed_outlines(checked_.problem.stages));
    if (checked_.problem.covers) fail(crossed_outlines(*checked_.problem.covers));
    if (checked_.problem.covers) add(*checked_.problem.covers, checked_.problem.loads);
    std::visit([this](auto& geometry) { look_at(geometry); }, checked_.problem.geometry);
    if (checked_.problem.analysis && checked_.problem.motion) take_motion();
    return std::move(checked_);
  }

 private:
  void look_at(std::monostate) {}

  void take_motion() {
    try {
      warn(apply_motion(*checked_.problem.analysis, *checked_.problem.motion));
      checked_.problem.motion.reset();
    } catch (const InputError& error) {
      checked_.errors.push_back(error);
    }
  }

  void look_at(Drawing& drawing) {
    warn(zero_length_lines(drawing));
    drop_zero_length_lines(drawing);
    warn(unusual_ratio(drawing));
    if (fixes_nothing(checked_.problem)) warn(no_fixed_points(checked_.problem.analysis, drawing.place));
    if (drawing.joints.empty())
      checked_.errors.emplace_back(drawing.place, "expected lines to cut blocks from, found none");
    if (checked_.problem.analysis) tell(clamp_materials(drawing, *checked_.problem.analysis));
    if (checked_.problem.analysis) give_bolts_their_properties(drawing, *checked_.problem.analysis);
    const auto place_of_bolt = [](const BoltLine& bolt) { return bolt.place; };
    fail(bolts_that_push(drawing.bolts, place_of_bolt));
    if (!checked_.problem.analysis) return;
    warn(idle_bolts(drawing.bolts, place_of_bolt));
    warn(curves_and_points(*checked_.problem.analysis, drawing.loading_points.size(), drawing.place));
  }

  void look_at(Blocks& blocks) {
    warn(zero_length_bolts(blocks));
    std::erase_if(blocks.bolts, [](const BlockBolt& bolt) { return is_point(bolt.segment); });
    if (fixes_nothing(checked_.problem)) warn(no_fixed_points(checked_.problem.analysis, blocks.place));
    fail(crossed_outlines(blocks));
    if (!checked_.errors.empty()) return;
    fail(impossible_blocks(blocks));
    fail(misplaced_holes(blocks));
    if (checked_.errors.empty()) warn(shared_ground(blocks));
    const auto place_of_bolt = [&](const BlockBolt& bolt) { return place_of(bolt, blocks); };
    fail(bolts_that_push(blocks.bolts, place_of_bolt));
    if (!checked_.problem.analysis) return;
    warn(idle_bolts(blocks.bolts, place_of_bolt));
    tell(clamp_materials(blocks, *checked_.problem.analysis));
    warn(curves_and_points(*checked_.problem.analysis, blocks.loading_points.size(), blocks.place));
  }

  void look_at(Cover& cover) {
    if (!has_fixed(cover)) warn(no_fixed_points(checked_.problem.analysis, cover.place));
    fail(crossed_outlines(cover));
    if (checked_.errors.empty()) fail(impossible_elements(cover));
    if (!checked_.problem.analysis) return;
    tell(clamp_materials(cover, *checked_.problem.analysis));
    warn(curves_and_points(*checked_.problem.analysis, cover.loading_points.size(), cover.place));
  }

  void warn(const Warnings& more) { checked_.warnings.insert(checked_.warnings.end(), more.begin(), more.end()); }

  void fail(const std::vector<InputError>& more) {
    checked_.errors.insert(checked_.errors.end(), more.begin(), more.end());
  }

  /// Old files and drawings run with the nearest number. In a case file that holds both geometry and materials, a
  /// number out of range is an error.
  void tell(const std::vector<NumberOutOfRange>& found) {
    for (const NumberOutOfRange& one : found)
      if (checked_.problem.has_own_case && one.place.file.text() == checked_.problem.analysis->place.file.text())
        checked_.errors.emplace_back(one.place, one.error);
      else
        checked_.warnings.push_back(warning_of(one.finding, one.place));
  }

  void drop_zero_length_lines(Drawing& drawing) {
    const auto boundaries = drawing.joints.begin() + static_cast<std::ptrdiff_t>(drawing.boundary_count);
    const auto is_dropped = [](const JointLine& line) { return is_point(line.segment); };
    drawing.boundary_count -= static_cast<std::size_t>(std::count_if(drawing.joints.begin(), boundaries, is_dropped));
    std::erase_if(drawing.joints, is_dropped);
    std::erase_if(drawing.bolts, [](const BoltLine& bolt) { return is_point(bolt.segment); });
  }

  /// Gives bolts their properties by type. A bolt whose drawing states its properties (native files) keeps them.
  void give_bolts_their_properties(Drawing& drawing, const Analysis& analysis) {
    const auto& properties = analysis.bolt_properties;
    if (properties.empty() || std::ranges::all_of(drawing.bolts, has_properties)) return;
    NumberRange type("bolt type", properties.size());
    for (BoltLine& bolt : drawing.bolts) {
      if (has_properties(bolt)) continue;
      bolt.type = type(bolt.type, bolt.place);
      const BoltProperties& own = properties[static_cast<std::size_t>(bolt.type)];
      bolt.stiffness = own.stiffness;
      bolt.strength = own.strength;
      bolt.pretension = own.pretension;
    }
    tell(type.replaced("bolt_type_clamped", "bolts"));
  }

  static bool has_properties(const BoltLine& bolt) {
    return bolt.stiffness != 0 || bolt.strength != 0 || bolt.pretension != 0;
  }

  Checked checked_;
};

bool has_tension(std::monostate) {
  return false;
}

template <class BoltsGeometry>
bool has_tension(const BoltsGeometry& geometry) {
  if constexpr (requires { geometry.bolts; })
    return std::ranges::any_of(geometry.bolts, [](const auto& bolt) { return bolt.pretension != 0; });
  return false;
}

bool acts(const TimeCurve& curve) {
  return std::ranges::any_of(curve.values, [](const Point& value) { return value != Point{}; });
}

}  // namespace

Checked check(Problem problem) {
  return Checker(std::move(problem)).check();
}

bool fixes_nothing(const Problem& problem) {
  if (problem.covers || !problem.loads.displacements.empty()) return false;
  return !std::visit([](const auto& geometry) { return has_fixed(geometry); }, problem.geometry);
}

bool is_unloaded(const Problem& problem) {
  const Analysis& analysis = *problem.analysis;
  const auto is_pushed = [](const BlockMaterial& m) { return m.is_stressed() || m.horizontal_force != 0; };
  return !has_weight(problem.analysis) && !problem.covers && problem.loads.empty() && problem.stages.empty() &&
         !problem.motion && !acts(analysis.body_acceleration) && std::ranges::none_of(analysis.point_loads, acts) &&
         std::ranges::none_of(analysis.fixed_point_motions, acts) &&
         std::ranges::none_of(analysis.block_materials, is_pushed) &&
         !std::visit([](const auto& geometry) { return has_tension(geometry); }, problem.geometry);
}

}  // namespace keyblock
