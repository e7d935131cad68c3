// A picture of how cracks went on: their path in the undeformed bodies, and what pulled at their tips on the way.
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

/// An SVG document: the bodies of the first frame with the paths of all tips and the cracks as they are at the end,
/// those that started in shear in a colour of their own; the bodies as they lie at the end, small displacements
/// enlarged; K_I and K_II of each tip over the length of its crack, and, where cracks grow, the factor of the loads.
std::string crack_picture(const CrackPicture& picture);

}  // namespace keyblock::report
