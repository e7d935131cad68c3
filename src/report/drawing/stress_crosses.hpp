// Draws principal stresses as crosses, which show directions and amounts; colours show one value.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "report/drawing/field_patches.hpp"

namespace keyblock::report {

/// Length of the line of a stress.
struct CrossScale {
  double sample = 0;     ///< a round stress; 0: none
  double length = 0;     ///< of its line, page units
  bool are_cut = false;  ///< the longest few are drawn shorter
};

/// Draws crosses at the middles of elements, none so near that they would cover each other. Their lines lie along the
/// principal stresses in the plane and have their length, with one colour for compression and one for tension. The few
/// longest are cut. `most`: the stress of the longest line; 0: that of all crosses but the longest few.
CrossScale draw_crosses(SvgPage& page, const PageMap& map, const FieldFrame& field, const CornerPlace& place,
                        double most = 0);

/// Returns the stress that only the few greatest elements exceed.
double common_stress(const FieldFrame& field);

/// Draws both colours, and a line of the sample's length with its value, below `corner`.
void draw_cross_legend(SvgPage& page, Point corner, const CrossScale& scale, const Units& units);

}  // namespace keyblock::report
