// Builds the sentence part by part, with ranges of values if materials differ.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/scene_sentence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/counted.hpp"
#include "base/union_find.hpp"

namespace keyblock::study {
namespace {

std::string motion_of(const Analysis& analysis) {
  const double carried = analysis.velocity_carry_over;
  const std::string motion = carried == 0   ? "static"
                             : carried == 1 ? "dynamic"
                                            : fmt::format("damped, velocities times {:g} per step", carried);
  return fmt::format("{}, {} of {:g}", motion, counted(static_cast<std::size_t>(analysis.step_count), "step"),
                     analysis.time_step);
}

std::string of_bodies(std::size_t bodies, std::string_view noun, std::size_t held) {
  if (bodies == 1) return fmt::format("1 {}, {}", noun, held == 1 ? "fixed" : "not fixed");
  return fmt::format("{}, {} of them fixed", counted(bodies, noun), held == 0 ? "none" : fmt::to_string(held));
}

std::string loads_of(const Analysis& analysis, std::size_t points) {
  double greatest = 0;
  for (const TimeCurve& curve : analysis.point_loads)
    for (const Point& force : curve.values) greatest = std::max(greatest, length(force));
  if (points == 0 || greatest == 0) return "no point load";
  return fmt::format("{} of up to {:g}", counted(points, "point load"), greatest);
}

/// Returns the value of all materials, as least and greatest if they differ.
template <class Material, class Value>
std::string range_of(const std::vector<Material>& materials, Value value) {
  const auto [least, greatest] = std::ranges::minmax_element(materials, {}, value);
  const double low = value(*least);
  const double high = value(*greatest);
  return low == high ? fmt::format("{:g}", low) : fmt::format("{:g} to {:g}", low, high);
}

// Takes unit weights of files in Shi's formats, or the densities of a case under its gravity.
std::string weight_of(const Analysis& analysis) {
  const auto& all = analysis.block_materials;
  if (std::ranges::any_of(all, [](const BlockMaterial& m) { return m.unit_weight != 0; }))
    return fmt::format("; weight {}", range_of(all, [](const BlockMaterial& m) { return m.unit_weight; }));
  const bool has_mass = std::ranges::any_of(all, [](const BlockMaterial& m) { return m.density != 0; });
  if (analysis.gravity.value_or(0) == 0 || !has_mass) return "; no weight";
  return fmt::format("; density {} under gravity of {:g}",
                     range_of(all, [](const BlockMaterial& m) { return m.density; }), *analysis.gravity);
}

std::string materials_of(const Analysis& analysis) {
  std::string text;
  if (const auto& all = analysis.block_materials; !all.empty()) {
    text += fmt::format("; E {}, Poisson's ratio {}",
                        range_of(all, [](const BlockMaterial& m) { return m.youngs_modulus; }),
                        range_of(all, [](const BlockMaterial& m) { return m.poissons_ratio; }));
    text += weight_of(analysis);
    const auto is_pushed = [](const BlockMaterial& m) { return m.horizontal_force != 0; };
    if (std::ranges::any_of(all, is_pushed))
      text += fmt::format(", horizontal body force {}",
                          range_of(all, [](const BlockMaterial& m) { return m.horizontal_force; }));
  }
  if (const auto& all = analysis.joint_materials; !all.empty())
    text += fmt::format("; friction {} degrees",
                        range_of(all, [](const JointMaterial& m) { return m.friction_angle_deg; }));
  return text;
}

std::string sentence_of(const Analysis& analysis, const std::string& bodies, std::size_t loading_points) {
  return fmt::format("{}; {}; {}{}", motion_of(analysis), bodies, loads_of(analysis, loading_points),
                     materials_of(analysis));
}

}  // namespace

std::string scene_sentence(const Cover& cover, const Analysis& analysis) {
  UnionFind groups(cover.nodes.size());
  for (const CoverElement& element : cover.elements)
    for (const int other : element.covers) groups.unite(element.covers[0], other);
  std::set<int> bodies;
  std::set<int> held;
  for (const CoverElement& element : cover.elements) bodies.insert(groups.find(element.covers[0]));
  for (const CoverPoint& point : cover.fixed_points)
    held.insert(groups.find(cover.elements[static_cast<std::size_t>(point.element)].covers[0]));
  return sentence_of(analysis,
                     fmt::format("{}, of {} on {}", of_bodies(bodies.size(), "piece", held.size()),
                                 counted(cover.elements.size(), "element"), counted(cover.nodes.size(), "cover")),
                     cover.loading_points.size());
}

std::string scene_sentence(const Blocks& blocks, const Analysis& analysis) {
  std::set<int> held;
  for (const BlockPoint& point : blocks.fixed_points) held.insert(point.block);
  return sentence_of(analysis, of_bodies(blocks.blocks.size(), "block", held.size()), blocks.loading_points.size());
}

}  // namespace keyblock::study
