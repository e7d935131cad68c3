// Draws crack growth: paths in the undeformed bodies, and stress intensity at the tips over the length.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/run_choices.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"

namespace keyblock::report {

struct CrackPicture {
  std::string title;
  const Frame& start;
  const History& history;
  const FieldFrame& end;
  Units units = {};
};

/// Returns an SVG document. It has the bodies of the first frame with the paths of all tips and the final cracks; those
/// that started in shear have their own colour. It has the bodies at the end, with small displacements enlarged. It has
/// K_I and K_II of each tip over the length of its crack and, if cracks grow, the load factor.
std::string crack_picture(const CrackPicture& picture);

}  // namespace keyblock::report
