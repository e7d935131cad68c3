// Draws elastoplastic rock: plastic strain, mean stress, and state on the yield surface.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/run_choices.hpp"
#include "result/field_frame.hpp"

namespace keyblock::report {

struct PlasticPicture {
  std::string title;
  FieldFrame end;
  std::vector<std::vector<Point>> outlines;  ///< of NMM bodies, as they lie at the end
  Units units = {};
};

/// An SVG document: three panels of the bodies as they lie at the end, placed so that they are large. Equivalent
/// plastic strain from none upwards; mean stress, tension positive, white at zero; and of each element whether it
/// yields, and on which part of its surface, has yielded before, or has not.
std::string plastic_picture(const PlasticPicture& picture);

}  // namespace keyblock::report
