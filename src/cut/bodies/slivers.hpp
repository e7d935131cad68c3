// Which blocks are slivers: so small or so narrow beside the others that they fail to come to rest and need small
// steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "geometry/point.hpp"
#include "problem/blocks.hpp"

namespace keyblock {

inline constexpr double kSliverArea = 0.01;   ///< of the mean area of all blocks; smaller blocks are slivers
inline constexpr double kSliverWidth = 0.02;  ///< mean width over length; narrower blocks are slivers

/// The size of a block, in the units of the input.
struct BlockForm {
  Point centroid;     ///< of its outer loop
  double area = 0;    ///< less its holes
  double length = 0;  ///< the greatest distance of two corners

  double width() const { return length > 0 ? area / length : 0; }  ///< in the mean
};

BlockForm form_of(const BlockPolygon& block);

bool is_sliver(const BlockForm& form, double mean_area);

/// "below 1 % of the mean area or narrower than 2 % of their length".
std::string slivers_in_words();

}  // namespace keyblock
