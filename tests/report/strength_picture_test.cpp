// Pictures of strength reduction: slip of two squares worked out by hand, and what the documents hold.
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

// The lower square's top runs to the left, with the square on its left: what lies above moves by (0.3, 0.1).
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
  for (const char* part :
       {"stands at 1", "falls at 1.1", "plastic strain, 0 to 0.01", "slip 0.3, opening 0.1", "</svg>"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  StrengthPicture standing = picture;
  standing.falling.reset();
  EXPECT_EQ(strength_picture(standing).find("slip 0.3"), std::string::npos);
}

TEST(StrengthPicture, the_chart_names_both_ends_of_the_bracket) {
  const std::string svg = strength_chart({"a case", {{1, 0.01, true}, {1.25, 0.02, true}, {1.3, 7, false}}, 1.25, 1.3});
  EXPECT_NE(svg.find("stands up to 1.25"), std::string::npos);
  EXPECT_NE(svg.find("falls from 1.3"), std::string::npos);
}

}  // namespace keyblock::report::strength_picture_test
