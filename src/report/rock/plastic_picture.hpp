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

/// Returns an SVG document with three panels of the bodies at the end, placed so that they are large. They show the
/// equivalent plastic strain, the mean stress (tension positive, white at zero), and the state of each element:
/// yielding on a part of its surface, yielded before, or elastic.
std::string plastic_picture(const PlasticPicture& picture);

}  // namespace keyblock::report
