// Compares area and width with the two limits.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/slivers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cut/bodies/block_shape.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {

BlockForm form_of(const BlockPolygon& block) {
  const std::vector<Point> points = points_of(block.outer);
  BlockForm form{centroid(points), area_of(block)};
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      form.length = std::max(form.length, distance(points[i], points[j]));
  return form;
}

bool is_sliver(const BlockForm& form, double mean_area) {
  const bool is_narrow = form.width() < kSliverWidth * form.length;
  return form.area <= (is_narrow ? 1 : kSliverArea) * mean_area;
}

std::string slivers_in_words() {
  return fmt::format(
      "below {:g} % of the mean area, or no larger than the mean and narrower than {:g} % of their length",
      100 * kSliverArea, 100 * kSliverWidth);
}

}  // namespace keyblock
