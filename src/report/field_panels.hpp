// Arranges title and panels of a picture of a field on its page.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "report/drawing/svg.hpp"

namespace keyblock::report {

/// Width of the narrowest page with three panels.
inline constexpr double kLeastForThree = 700;

/// Places of the mesh, the deformed mesh and the field; a panel without room is not drawn.
struct Panels {
  std::array<Point, 3> corners;
  std::array<Point, 3> rooms;
  double bottom = 0;
};

/// Leaves no half of the page empty; see `field_picture`.
Panels place_panels(const Box& box, double wide, double below_title);

/// Title in lines that fit the page, broken at its commas.
struct PageTitle {
  std::vector<std::string> lines;
  double size = 0;
  double bottom = 0;
};

PageTitle title_of(const std::string& words, double room, bool is_narrow);
void draw_title(SvgPage& page, const PageTitle& title);

}  // namespace keyblock::report
