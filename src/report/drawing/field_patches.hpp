// Draws a value over the elements in colour, with a colour bar, for all pictures of fields.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "report/drawing/readable.hpp"
#include "report/drawing/svg.hpp"
#include "result/field_frame.hpp"

namespace keyblock::report {

using CornerPlace = std::function<Point(const FieldCorner&)>;
using CornerValue = std::function<double(const FieldCorner&)>;

inline Point as_drawn(const FieldCorner& corner) {
  return corner.position;
}

inline Point as_moved(const FieldCorner& corner) {
  return corner.position + corner.displacement;
}

/// Calls `visit(corner)` with every corner.
template <class Visit>
void visit_corners(const FieldFrame& field, Visit visit) {
  for (const FieldElement& element : field.elements)
    for (const auto& loop : element.loops)
      for (const FieldCorner& corner : loop) visit(corner);
}

Box bounds(const FieldFrame& field, const CornerPlace& place);
std::vector<std::vector<Point>> loops_of(const FieldElement& element, const CornerPlace& place);

/// Elements of a field that are drawn as triangles: of more than these, a triangle has about six pixels of the page.
inline constexpr std::size_t kMostSplit = 50'000;

/// One triangle of the middle and an edge. An element with holes, of one state, or of a field with more than
/// `kMostSplit` elements is one piece with the value of its middle.
struct Patch {
  std::vector<std::vector<Point>> loops;
  double value = 0;
};

std::vector<Patch> patches_of(const FieldFrame& field, const CornerValue& value, const CornerPlace& place);

/// Straight piece of a line of equal value.
using ContourLine = std::array<Point, 2>;

/// Lines of equal value over the triangles of `patches_of`, in which it is linear; none in elements that are one piece.
/// They end at elements' edges where neighbours disagree.
std::vector<ContourLine> contours_of(const FieldFrame& field, const CornerValue& value, const CornerPlace& place,
                                     const std::vector<double>& levels);

/// Colours of the values from `low` to `high`.
struct ColourScale {
  enum class Map {
    /// From blue through white at 0 to red, as strong on either side. A side without values is left out; where all
    /// values are far from 0, from pale to strong blue, or red.
    about_zero,
    rising  ///< from pale at `low` to dark red
  };
  double low = 0;
  double high = 1;
  Map map = Map::about_zero;
  bool has_below = false;  ///< values beyond an end have its colour
  bool has_above = false;

  std::string colour(double value) const;
};

/// Returns the ends of the values of patches, without the most extreme ones by area, because meshes are fine where
/// values peak. `about_zero` has zero at an end if one sign is absent, unless the value nearest to it is more than half
/// of the farthest; `rising` begins at zero and counts the area above.
ColourScale scale_of(const std::vector<Patch>& patches, ColourScale::Map map = ColourScale::Map::about_zero);

/// Returns the scale that covers both.
ColourScale covering(const ColourScale& one, const ColourScale& other);

/// Returns the scale with the ends beyond which values of the patches lie; these have the colour of the end.
ColourScale with_ends(ColourScale scale, const std::vector<Patch>& patches);

/// Returns the ends from the least value to the greatest, without the same extreme ones.
double range_of(const std::vector<Patch>& patches);

/// `seam`: width of the line round each patch that hides the gap to the next.
void draw_patches(SvgPage& page, const PageMap& map, const std::vector<Patch>& patches, const ColourScale& scale,
                  double seam = 0.3);
void draw_colour_bar(SvgPage& page, Point corner, double height, const ColourScale& scale, const Described& quantity);

}  // namespace keyblock::report
