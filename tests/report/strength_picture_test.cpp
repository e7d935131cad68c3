// Pictures of strength reduction: slip of two squares by hand, and the contents of the documents.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/rock/strength_picture.hpp"

#include <gtest/gtest.h>

namespace keyblock::report::strength_picture_test {
namespace {

FieldElement square(int body, Point corner, Point displacement) {
  FieldElement element;
  element.body = body;
  auto& loop = element.loops.emplace_back();
  for (const Point p : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}})
    loop.push_back({corner + p, displacement, {}});
  element.middle = {corner + Point{0.5, 0.5}, displacement, {}};
  return element;
}

/// A square whose right half lies along the left half of the top of another.
FieldFrame two_squares(int other_body, Point displacement) {
  return {0, 0, {square(0, {0, 0}, {0, 0}), square(other_body, {-0.5, 1}, displacement)}};
}

}  // namespace

// The lower square's top runs to the left, with the square on its left: the square above moves by (0.3, 0.1).
TEST(StrengthPicture, slip_is_that_of_the_shared_stretch) {
  const auto lines = slip_lines(two_squares(1, {0, 0}), two_squares(1, {0.3, 0.1}));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(std::abs(lines[0].to.x - lines[0].from.x), 0.5, 1e-12);
  EXPECT_NEAR(lines[0].from.y, 1, 1e-12);
  EXPECT_NEAR(lines[0].slip, 0.3, 1e-12);     // of the lower against the upper, along (-1, 0)
  EXPECT_NEAR(lines[0].opening, 0.1, 1e-12);  // of the lower away from the upper, along (0, -1)
}

TEST(StrengthPicture, elements_of_one_body_have_no_joint_between_them) {
  EXPECT_TRUE(slip_lines(two_squares(0, {0, 0}), two_squares(0, {0.3, 0.1})).empty());
}

TEST(StrengthPicture, shows_both_states_and_what_slips) {
  const StrengthPicture picture{"a case",      two_squares(1, {0, 0}), {0, 0.01},
                                "stands at 1", two_squares(1, {0, 0}), two_squares(1, {0.3, 0.1}),
                                "falls at 1.1"};
  const std::string svg = strength_picture(picture);
  for (const char* part : {"stands at 1", "falls at 1.1", "0.01  plastic strain", "slip 0.3, opening 0.1", "</svg>"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  StrengthPicture standing = picture;
  standing.falling.reset();
  EXPECT_EQ(strength_picture(standing).find("slip 0.3"), std::string::npos);
}

// A tall model leaves half the page empty if its states stand one above the other.
TEST(StrengthPicture, states_of_a_tall_model_are_side_by_side) {
  const auto height = [](double width) {
    FieldFrame field{0, 0, {square(0, {0, 0}, {0, 0}), square(1, {width - 1, 1}, {0, 0})}};
    const std::string svg = strength_picture({"a case", field, {0, 0}, "stands at 1", field, field, "falls at 1.1"});
    const std::size_t at = svg.find("height=\"") + 8;
    return std::stod(svg.substr(at));
  };
  EXPECT_LT(height(2), 650) << "as tall as wide: 411 of 900 units each";
  EXPECT_NEAR(height(8), 44 + 26 + 210 + 40 + 210 + 50, 2) << "four times as wide";
}

// The displacement of an unstable trial is not drawn: the end of an abandoned search says nothing.
TEST(StrengthPicture, the_chart_shows_what_falls_without_a_height_and_never_green) {
  using Kind = StrengthPoint::Kind;
  const StrengthChart chart{
      "a case", {{1, 0.01, Kind::stands}, {1.25, 0.02, Kind::stands}, {1.3, 7, Kind::falls}}, 1.25, 1.3};
  const std::string svg = strength_chart(chart);
  EXPECT_NE(svg.find("stable up to 1.25, unstable from 1.3"), std::string::npos);
  EXPECT_NE(svg.find("unstable (displacement not drawn)"), std::string::npos);
  for (const char* green : {"#009e73", "#809b8f", "green"}) EXPECT_EQ(svg.find(green), std::string::npos);
  StrengthChart higher = chart;
  higher.points[2].displacement = 0.001;
  EXPECT_EQ(strength_chart(higher), svg);
  EXPECT_NE(svg.find("F = 1.3<"), std::string::npos) << "its cross";
}

TEST(StrengthPicture, the_chart_says_from_where_displacements_grow) {
  StrengthChart chart{"a case", {{1, 0.01}, {1.25, 0.2}}, 1.25, {}};
  EXPECT_EQ(strength_chart(chart).find("displacements grow"), std::string::npos);
  chart.service = 1.2;
  EXPECT_NE(strength_chart(chart).find("displacements grow from 1.2"), std::string::npos);
}

TEST(StrengthPicture, bolts_are_there_with_what_they_carry) {
  StrengthPicture picture{"a case",      two_squares(1, {0, 0}), {0, 0.01},
                          "stands at 1", two_squares(1, {0, 0}), two_squares(1, {0.3, 0.1}),
                          "falls at 1.1"};
  picture.bolts = {{{{0, 0}, {0.5, 1.5}}, 12.5, false}, {{{0.2, 0}, {0.7, 1.5}}, 40, true}};
  const std::string svg = strength_picture(picture);
  for (const char* part : {"2 bolts, 1 at full strength", ">12.5<", ">40 (at its strength)<"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
}

}  // namespace keyblock::report::strength_picture_test
