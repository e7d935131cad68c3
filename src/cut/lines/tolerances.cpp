// Scale and tolerances of a drawing; see tolerances.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/tolerances.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/box.hpp"

namespace keyblock {
namespace {

Box bounding_box(const std::vector<JointLine>& lines) {
  Box box;
  for (const JointLine& line : lines) {
    for (const Point p : {line.segment.start, line.segment.end}) box.add(p);
  }
  return box;
}

}  // namespace

CutTolerances cut_tolerances(const Drawing& drawing) {
  if (drawing.joints.empty()) return {};
  const Box box = bounding_box(drawing.joints);
  const Point size = box.high - box.low;
  const double greatest =
      std::max({std::fabs(box.low.x), std::fabs(box.low.y), std::fabs(box.high.x), std::fabs(box.high.y)});
  const double e0 = drawing.edge_node_ratio;
  CutTolerances result;
  result.scale = 1.02 * std::max(size.y / 2, size.x / 2 / 1.3);
  const double w0 = result.scale;
  result.merge = 1.25 * e0 * w0;
  result.near_pass = e0 * w0;
  result.reach_ratio = e0 > 0 ? 1e-7 : 0;
  // 1e-9 w0: files carry ten digits; 64 ulp of the greatest coordinate: a drawing far from the origin carries
  // fewer.
  result.round_off = e0 > 0 ? std::max(1e-9 * w0, 64 * std::numeric_limits<double>::epsilon() * greatest) : 0;
  // 1e-9 w0² is the old value; the second keeps it small against a block of the merging size where e0 is
  // below 0.001.
  result.collinear = std::min(1e-9, 1e-3 * e0 * e0) * w0 * w0;
  result.inset = 0.005 * w0;
  result.vertex_catch = 1e-5 * w0;
  return result;
}

}  // namespace keyblock
