// Finds slivers: blocks so small or narrow next to the others that they do not come to rest and need small steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "geometry/point.hpp"
#include "problem/blocks.hpp"

namespace keyblock {

inline constexpr double kSliverArea = 0.01;   ///< per mean area of all blocks; smaller blocks are slivers
inline constexpr double kSliverWidth = 0.02;  ///< mean width over length; narrower ones up to the mean area

/// Size of a block, in the units of the input.
struct BlockForm {
  Point centroid;     ///< centroid of the outer loop
  double area = 0;    ///< area without holes
  double length = 0;  ///< greatest distance between two corners

  double width() const { return length > 0 ? area / length : 0; }  ///< mean width
};

BlockForm form_of(const BlockPolygon& block);

bool is_sliver(const BlockForm& form, double mean_area);

/// Returns "below 1 % of the mean area, or no larger than the mean and narrower than 2 % of their length".
std::string slivers_in_words();

}  // namespace keyblock
