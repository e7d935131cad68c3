// Chains boundary lines to loops, then cuts each joint at them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_clip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/sentences/sentences.hpp"
#include "base/words/plain_number.hpp"
#include "geometry/polygon.hpp"
#include "problem/joints/joint_drawing.hpp"
#include "problem/lines/outline_graph.hpp"

namespace keyblock::formats {
namespace {

// A joint that loses less than this fraction of its length at its ends stays unchanged.
constexpr double kUncut = 1e-9;
// Larger products of joints and boundary lines, about a second of work, are not tried.
constexpr double kMostPairs = 2e8;

// Fraction of the longest boundary line: a wider gap is a missing side. Joining would make another shape.
constexpr double kJoinable = 0.1;

double longest_side(const Drawing& drawing) {
  double longest = 0;
  for (std::size_t i = 0; i < drawing.boundary_count; ++i)
    longest = std::max(longest, distance(drawing.joints[i].segment.start, drawing.joints[i].segment.end));
  return longest;
}

Warnings not_clipped(const Drawing& drawing, const OutlineFault& fault) {
  const Place& place = drawing.joints[fault.line].place;
  Facts facts;
  facts.points = {{fault.at.x, fault.at.y}};
  if (fault.pieces > 1) {
    facts.numbers = {{"lines", fault.pieces}};
    return {warning_of({"dxf_not_clipped:branched", std::move(facts)}, place)};
  }
  facts.texts = {{"remedy", ""}};
  if (fault.nearest) {
    const double gap = distance(fault.at, *fault.nearest);
    facts.numbers = {{"gap", gap}};
    facts.points.push_back({fault.nearest->x, fault.nearest->y});
    if (fault.pieces == 1)
      facts.texts = {{"remedy", gap > kJoinable * longest_side(drawing)
                                    ? "; draw the side that is missing"
                                    : fmt::format("; --join {} closes it", plain(1.1 * gap, 2))}};
  }
  return {warning_of({"dxf_not_clipped", std::move(facts)}, place)};
}

bool lies_in(const Outline& inner, const Outline& outer) {
  return &inner != &outer && std::ranges::all_of(inner, [&](Point p) { return side(outer, p) != Side::outside; });
}

/// Returns the outermost loops, each followed by the loops inside it that hole points empty.
std::vector<std::vector<Outline>> regions_of(const std::vector<Outline>& loops, const Drawing& drawing) {
  const auto is_within = [&](const Outline& loop) {
    return std::ranges::any_of(loops, [&](const Outline& other) { return lies_in(loop, other); });
  };
  const auto is_emptied = [&](const Outline& loop) {
    return std::ranges::any_of(drawing.hole_points,
                               [&](const MarkedPoint& p) { return side(loop, p.position) == Side::inside; });
  };
  std::vector<std::vector<Outline>> regions;
  for (const Outline& loop : loops) {
    if (is_within(loop)) continue;
    std::vector<Outline>& region = regions.emplace_back(1, loop);
    for (const Outline& inner : loops)
      if (lies_in(inner, loop) && is_emptied(inner)) region.push_back(inner);
  }
  return regions;
}

bool is_whole(const std::vector<Segment>& pieces, const Segment& segment) {
  const double small = kUncut * distance(segment.start, segment.end);
  return pieces.size() == 1 && distance(pieces[0].start, segment.start) <= small &&
         distance(pieces[0].end, segment.end) <= small;
}

}  // namespace

Warnings clip_joints(Drawing& drawing) {
  if (drawing.boundary_count == 0 || drawing.joints.size() == drawing.boundary_count) return {};
  const double pairs = double(drawing.boundary_count) * double(drawing.joints.size() - drawing.boundary_count);
  const Place first = drawing.joints.front().place;
  if (pairs > kMostPairs) return {warning_of({"dxf_not_clipped:too_many"}, first)};
  const OutlineGraph outline(std::span(drawing.joints).first(drawing.boundary_count));
  if (outline.is_tangled()) return {warning_of({"dxf_not_clipped:tangled"}, first)};
  if (const auto fault = outline.fault()) return not_clipped(drawing, *fault);
  const std::vector<std::vector<Outline>> regions = regions_of(outline.loops(), drawing);
  std::size_t cut = 0;
  std::size_t gone = 0;
  std::vector<JointLine> kept(drawing.joints.begin(),
                              drawing.joints.begin() + static_cast<std::ptrdiff_t>(drawing.boundary_count));
  for (std::size_t i = drawing.boundary_count; i < drawing.joints.size(); ++i) {
    const JointLine& joint = drawing.joints[i];
    std::vector<Segment> pieces;
    for (const std::vector<Outline>& region : regions)
      for (const Segment& piece : clipped(joint.segment, region)) pieces.push_back(piece);
    if (is_whole(pieces, joint.segment)) {
      kept.push_back(joint);
      continue;
    }
    ++(pieces.empty() ? gone : cut);
    for (const Segment& piece : pieces) kept.push_back({piece, joint.joint_material, joint.place});
  }
  if (cut + gone == 0) return {};
  drawing.joints = std::move(kept);
  return {warning_of({"dxf_clipped", {{{"shortened", cut}, {"removed", gone}}}}, first)};
}

}  // namespace keyblock::formats
