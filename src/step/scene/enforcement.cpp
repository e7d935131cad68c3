// Finds rings of blocks: a ring closes if a pair joins two blocks that are already connected.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/enforcement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/union_find.hpp"
#include "geometry/segment.hpp"
#include "step/newton/tolerances.hpp"

namespace keyblock {
namespace {

bool has_corner_on(const Model& model, ElementIndex corners, ElementIndex edges, double tolerance) {
  const auto place = [&](VertexIndex v) { return model.start_vertices[static_cast<std::size_t>(v.value)]; };
  for (VertexIndex corner : model.elements[corners].vertices())
    for (VertexIndex v : model.elements[edges].vertices())
      if (distance(Segment{place(v), place(model.vertices[v].next)}, place(corner)) <= tolerance) return true;
  return false;
}

// Up to this number of movable blocks multipliers serve even in a ring.
constexpr std::ptrdiff_t kFewBlocks = 8;

bool has_few_blocks(const Model& model) {
  return std::ranges::count_if(model.elements, &Element::can_move) <= kFewBlocks;
}

bool is_automatic(Enforcement enforcement) {
  return enforcement == Enforcement::automatic;
}

}  // namespace

std::vector<ElementPair> touching_pairs(const Model& model) {
  const double tolerance = tolerances::of_gaps::kTouching * std::sqrt(model.mean_area);
  State state;
  state.vertices.assign(model.start_vertices.begin(), model.start_vertices.end());
  std::vector<ElementPair> pairs = close_pairs(model, state, tolerance);
  std::erase_if(pairs, [&](const ElementPair& pair) {
    return !has_corner_on(model, pair.lower, pair.upper, tolerance) &&
           !has_corner_on(model, pair.upper, pair.lower, tolerance);
  });
  return pairs;
}

bool has_ring(const Model& model, const std::vector<ElementPair>& touching) {
  const int held = static_cast<int>(model.elements.size());
  const auto node = [&](ElementIndex e) { return !model.elements[e].can_move() ? held : e.value; };
  std::set<std::pair<int, int>> joins;  // once, even if a block touches several fixed blocks
  for (const ElementPair& pair : touching) {
    const auto [lower, upper] = std::minmax({node(pair.lower), node(pair.upper)});
    if (lower != upper) joins.emplace(lower, upper);
  }
  UnionFind groups(model.elements.size() + 1);
  return std::ranges::any_of(joins, [&](const auto& join) { return !groups.unite(join.first, join.second); });
}

Settings with_enforcement_decided(Settings settings, const Model& model) {
  auto& [common, own] = settings.standard.enforcement;
  const bool is_asked = is_automatic(common) ||
                        std::ranges::any_of(own, [](const auto& material) { return is_automatic(material.second); });
  if (!is_asked) return settings;
  // Faces of many elements meet at more points than have independent forces.
  const bool needs_springs = settings.standard.impact == ImpactLaw::springs || model.shares_unknowns() ||
                             (!has_few_blocks(model) && has_ring(model, touching_pairs(model)));
  const Enforcement decided = needs_springs ? Enforcement::penalty : Enforcement::lagrange;
  if (is_automatic(common)) common = decided;
  for (auto& [material, enforcement] : own)
    if (is_automatic(enforcement)) enforcement = decided;
  return settings;
}

std::string why_enforcement(const Model& model, const Settings& settings) {
  if (settings.standard.impact == ImpactLaw::springs) return "springs stop blocks that meet";
  if (model.shares_unknowns()) return "faces of NMM bodies";
  if (has_few_blocks(model)) return fmt::format("at most {} blocks can move", kFewBlocks);
  return has_ring(model, touching_pairs(model)) ? "blocks in contact form a ring" : "no blocks in contact form a ring";
}

}  // namespace keyblock
