// The extremes of two frames whose displacements and stresses are known.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/extremes.hpp"

#include <gtest/gtest.h>

namespace keyblock::result_extremes_test {
namespace {

ElementFrame triangle(Point shift, Stress stress) {
  ElementFrame element;
  element.loops = {{shift, shift + Point{1, 0}, shift + Point{0, 1}}};
  element.stress = stress;
  element.area = 0.5;
  return element;
}

Frame frame_of(std::vector<ElementFrame> elements) {
  Frame frame;
  frame.elements = std::move(elements);
  return frame;
}

}  // namespace

TEST(Extremes, principal_stresses_are_those_of_mohrs_circle) {
  EXPECT_EQ(principal({3, 3, 0}), (std::pair<double, double>{3, 3}));
  EXPECT_EQ(principal({0, 0, 2}), (std::pair<double, double>{-2, 2}));
  EXPECT_EQ(principal({7, 1, 4}), (std::pair<double, double>{-1, 9}));  // centre 4, radius 5
}

TEST(Extremes, name_the_elements_that_moved_and_bore_most) {
  const Frame start = frame_of({triangle({0, 0}, {}), triangle({2, 0}, {}), triangle({4, 0}, {})});
  Frame end = frame_of({triangle({0, 0}, {0, 0, 2}), triangle({5, 4}, {7, 1, 4}), triangle({4, 0}, {-8, -1, 0})});
  const Extremes found = extremes_of(start, end);
  EXPECT_DOUBLE_EQ(found.displacement, 5);
  EXPECT_EQ(found.displaced_element, 1);
  EXPECT_DOUBLE_EQ(found.least_stress, -8);
  EXPECT_EQ(found.compressed_element, 2);
  EXPECT_DOUBLE_EQ(found.greatest_stress, 9);
  EXPECT_EQ(found.stretched_element, 1);
  EXPECT_EQ(found.area_share, 1);
  end.elements[2].area = 0.125;
  EXPECT_DOUBLE_EQ(extremes_of(start, end).area_share, 0.25);
  EXPECT_EQ(extremes_of(start, end).crushed_element, 2);
  end.elements[2].loops[0][1].x += 6;  // one corner alone
  EXPECT_DOUBLE_EQ(extremes_of(start, end).displacement, 6);
}

// Both triangles moved by 5: which one is named may not depend on rounding.
TEST(Extremes, name_the_first_of_places_that_moved_equally_far) {
  const Frame start = frame_of({triangle({0, 0}, {}), triangle({2, 0}, {})});
  const Frame end = frame_of({triangle({3, 4}, {}), triangle({5, 4 + 1e-12}, {})});
  EXPECT_EQ(extremes_of(start, end).displaced_element, 0);
  EXPECT_DOUBLE_EQ(extremes_of(start, end).displaced_from.x, 0);
}

// A start in equilibrium had moved the square by 3 before the first frame, the run by 4 across.
TEST(Extremes, displacements_count_from_the_drawing_where_the_field_tells_them) {
  const Frame start = frame_of({triangle({3, 0}, {})});
  const Frame end = frame_of({triangle({3, 4}, {})});
  FieldFrame field;
  field.elements.resize(1);
  field.elements[0].loops = {{{{0, 0}, {3, 4}, {}}, {{1, 0}, {3, 4}, {}}, {{0, 1}, {3, 3}, {}}}};
  EXPECT_DOUBLE_EQ(extremes_of(start, end, field).displacement, 5);
  EXPECT_DOUBLE_EQ(extremes_of(start, end).displacement, 4);
}

TEST(Extremes, pressure_on_all_sides_has_no_tension) {
  const Frame end = frame_of({triangle({0, 0}, {-2, -3, 0})});
  EXPECT_EQ(extremes_of(end, end).greatest_stress, -2);
  EXPECT_EQ(extremes_of({}, {}).displacement, 0);
}

}  // namespace keyblock::result_extremes_test
