// Chains boundary lines to loops, then cuts each joint at them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_clip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/polygon.hpp"
#include "problem/joints/joint_drawing.hpp"

namespace keyblock::formats {
namespace {

// Ends of boundary lines nearer than this share of the drawing's extent meet: drawing programs snap.
constexpr double kSameEnd = 1e-9;
// A joint that loses less than this share of its length at its ends is left as it was drawn.
constexpr double kUncut = 1e-9;
// Products of joints and boundary lines beyond this are not tried, about a second.
constexpr double kMostPairs = 2e8;

using Cell = std::pair<long long, long long>;

/// Lines end to end.
class Chains {
 public:
  explicit Chains(const Drawing& drawing) : drawing_(drawing) {
    double extent = 0;
    const Point first = drawing.joints.front().segment.start;
    for (std::size_t i = 0; i < drawing.boundary_count; ++i)
      for (const Point p : {segment(i).start, segment(i).end}) extent = std::max(extent, distance(p, first));
    cell_ = std::max(kSameEnd * extent, 1e-300);
    for (std::size_t i = 0; i < drawing.boundary_count; ++i)
      for (const Point p : {segment(i).start, segment(i).end}) lines_at_[cell_of(p)].push_back(i);
  }

  /// Where not exactly two lines meet; none where all chains are closed.
  std::optional<std::size_t> loose_line() const {
    for (const auto& [cell, lines] : lines_at_)
      if (lines.size() != 2) return lines.front();
    return std::nullopt;
  }

  /// Of closed chains.
  std::vector<Outline> loops() const {
    std::vector<Outline> loops;
    std::vector<bool> is_used(drawing_.boundary_count, false);
    for (std::size_t first = 0; first < drawing_.boundary_count; ++first) {
      if (is_used[first]) continue;
      Outline loop;
      Point at = segment(first).start;
      for (std::size_t line = first; !is_used[line];) {
        is_used[line] = true;
        loop.push_back(at);
        at = cell_of(segment(line).start) == cell_of(at) ? segment(line).end : segment(line).start;
        const std::vector<std::size_t>& here = lines_at_.at(cell_of(at));
        line = here.front() == line ? here.back() : here.front();
      }
      if (loop.size() > 2) loops.push_back(std::move(loop));
    }
    return loops;
  }

 private:
  const Segment& segment(std::size_t i) const { return drawing_.joints[i].segment; }
  Cell cell_of(Point p) const { return {std::llround(p.x / cell_), std::llround(p.y / cell_)}; }

  const Drawing& drawing_;
  double cell_ = 0;
  std::map<Cell, std::vector<std::size_t>> lines_at_;
};

bool lies_in(const Outline& inner, const Outline& outer) {
  return &inner != &outer && std::ranges::all_of(inner, [&](Point p) { return side(outer, p) != Side::outside; });
}

/// Each outermost loop first, then the loops in it that hole points empty.
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
  if (pairs > kMostPairs)
    return {{"dxf_not_clipped", first, "too many boundary lines and joints to cut joints off at the boundary"}};
  const Chains chains(drawing);
  if (const auto loose = chains.loose_line())
    return {{"dxf_not_clipped", drawing.joints[*loose].place,
             "an end of this boundary line meets none or several others: joints are not cut off at the boundary"}};
  const std::vector<std::vector<Outline>> regions = regions_of(chains.loops(), drawing);
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
  return {{"dxf_clipped", first,
           fmt::format("the boundary cuts off joints that run beyond it: {} are shorter now or in pieces, {} lay "
                       "outside or along it and are gone",
                       cut, gone)}};
}

}  // namespace keyblock::formats
