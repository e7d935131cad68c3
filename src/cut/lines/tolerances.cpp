// Computes the scale and tolerances of a drawing; see tolerances.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/tolerances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "geometry/box.hpp"

namespace keyblock {
namespace {

Box bounding_box(const std::vector<JointLine>& lines, std::optional<Point> left_out = {}) {
  Box box;
  for (const JointLine& line : lines) {
    for (const Point p : {line.segment.start, line.segment.end})
      if (p != left_out) box.add(p);
  }
  return box;
}

double scale_of(const Box& box) {
  return 1.02 * std::max(box.size().y / 2, box.size().x / 2 / 1.3);
}

// Limits for a mistake in one coordinate, which can make the drawing and its merging distance a hundred times as large.
constexpr double kFarReach = 20;
constexpr double kSmallShare = 1.0 / 20;

// Circles of symbols are many short lines: without such a mistake, most lines must be shorter.
constexpr double kHalf = 0.5;
constexpr double kNearlyAll = 0.9;

/// Returns the value that a given share of all values does not exceed.
double at_share(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

void require_small_merging(const Drawing& drawing, const CutTolerances& tolerances) {
  std::vector<double> lengths, x, y, reaches;
  std::vector<const JointLine*> lines;
  for (const JointLine& line : drawing.joints) {
    const Segment& s = line.segment;
    if (s.start == s.end) continue;
    lines.push_back(&line);
    lengths.push_back(distance(s.start, s.end));
    x.insert(x.end(), {s.start.x, s.end.x});
    y.insert(y.end(), {s.start.y, s.end.y});
  }
  if (lines.empty() || tolerances.is_exact()) return;
  const Point middle{at_share(x, kHalf), at_share(y, kHalf)};
  for (const JointLine* line : lines)
    reaches.push_back(std::max(distance(middle, line->segment.start), distance(middle, line->segment.end)));
  const JointLine& line = *lines[static_cast<std::size_t>(std::ranges::max_element(reaches) - reaches.begin())];
  const auto& [start, end] = line.segment;
  const Point farthest = distance(middle, start) > distance(middle, end) ? start : end;
  const bool is_alone = tolerances.scale > kFarReach * scale_of(bounding_box(drawing.joints, farthest));
  const double length = at_share(lengths, is_alone ? kHalf : kNearlyAll);
  if (tolerances.merge < length * (is_alone ? kSmallShare : 1)) return;
  throw InputError(
      line.place,
      fmt::format(
          "expected points nearer than {:.3g} to one another to be few, because they become one, found lines of "
          "{:.3g}, or shorter. The line from ({:.9g}, {:.9g}) to ({:.9g}, {:.9g}) reaches farthest: correct "
          "it, or give a smaller edge_node_ratio than {:g}",
          tolerances.merge, length, start.x, start.y, end.x, end.y, drawing.edge_node_ratio));
}

CutTolerances cut_tolerances(const Drawing& drawing) {
  if (drawing.joints.empty()) return {};
  const Box box = bounding_box(drawing.joints);
  const double greatest =
      std::max({std::fabs(box.low.x), std::fabs(box.low.y), std::fabs(box.high.x), std::fabs(box.high.y)});
  const double e0 = drawing.edge_node_ratio;
  CutTolerances result;
  result.scale = scale_of(box);
  const double w0 = result.scale;
  result.merge = 1.25 * e0 * w0;
  result.near_pass = e0 * w0;
  result.reach_ratio = e0 > 0 ? 1e-7 : 0;
  // 1e-9 w0 because files carry ten digits; 64 ulp of the greatest coordinate because a drawing far from the origin
  // carries fewer.
  result.round_off = e0 > 0 ? std::max(1e-9 * w0, 64 * std::numeric_limits<double>::epsilon() * greatest) : 0;
  // 1e-9 w0² is Shi's value; the second keeps it small compared with a block of the merging size if e0 is below 0.001.
  result.collinear = std::min(1e-9, 1e-3 * e0 * e0) * w0 * w0;
  result.inset = 0.005 * w0;
  result.vertex_catch = 1e-5 * w0;
  return result;
}

}  // namespace keyblock
