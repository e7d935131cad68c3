// A comma that may be a decimal one stops the reading at its place; one that can only separate numbers does not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/formats/reading.hpp"

namespace keyblock::formats::decimal_comma_test {
namespace {

// Berkeley's analysis: controls, one block material, three joint materials.
std::string analysis_with(const std::string& friction_angle) {
  return "1\n10\n1\n3\n0.01\n0.01\n5 10 1000 0.25\n0 0 0\n0 0 0\n0 0 0\n" + friction_angle + " 0 0\n30 0 0\n30 0 0\n";
}

// One line with its material, and one fixed line: 0.01 1 0 0 0 1 0 0 0, then the records.
std::string geometry_with(const std::string& fixed_line) {
  return "0.01 1 0 0 0 1 0 0 0\n0 0 10 0 1\n" + fixed_line + "\n";
}

std::string refusal(const std::string& place, const std::string& found) {
  return "f:" + place +
         ": error: expected a decimal point, or white space beside a comma that parts two numbers, found \"" + found +
         "\"";
}

}  // namespace

TEST(DecimalComma, a_friction_angle_with_one_is_no_second_dialect) {
  EXPECT_EQ(error_of(analysis_with("22.5")), "");
  EXPECT_EQ(error_of(analysis_with("22,5")), refusal("11:3", "22,5"));
  EXPECT_EQ(error_of(analysis_with(",5e1")), refusal("11:1", ",5e1"));
}

TEST(DecimalComma, coordinates_with_one_are_no_surplus_numbers) {
  EXPECT_EQ(error_of(geometry_with("-1,5 0,5 10,5 0,5")), refusal("3:3", "-1,5"));
}

TEST(DecimalComma, thousands_are_refused_alike) {
  EXPECT_EQ(error_of(geometry_with("0 0 1,200 0")), refusal("3:6", "1,200"));
  EXPECT_EQ(error_of(geometry_with("0 0 1,200.5 0")), refusal("3:6", "1,200.5"));
  EXPECT_EQ(error_of(geometry_with("0 0 1.200,5 0")), refusal("3:10", "1.200,5"));
}

TEST(DecimalComma, a_file_that_fits_nothing_names_the_comma_too) {
  EXPECT_EQ(error_of("7,5 1 2"), refusal("1:2", "7,5"));
}

TEST(DecimalComma, commas_beside_white_space_part_numbers) {
  EXPECT_EQ(error_of("0.01, 1, 0, 0, 0, 1, 0, 0, 0,\n0, 0, 10, 0, 1\n0 , 0 , 10 , 0\n"), "");
}

TEST(DecimalComma, a_file_whose_commas_elsewhere_can_only_part_numbers_is_believed) {
  EXPECT_EQ(error_of("0.01,1,0,0,0,1,0,0,0\n0,0,10,0,1\n0,0\n10,0\n"), "");
  EXPECT_EQ(error_of("0.01,1,0,0,0,1,0,0,0\n0,0,10,0,1\n0,5 10 0\n"), refusal("3:2", "0,5"));
}

TEST(DecimalComma, comments_and_text_behind_the_numbers_may_hold_any) {
  EXPECT_EQ(error_of(geometry_with("0 0 10 0 # 22,5 degrees") + "end 1,5\n"), "");
}

TEST(DecimalComma, an_attribute_of_ddaml_with_one_is_no_smaller_number) {
  EXPECT_EQ(error_of("<DDA><Analysis><Gravaccel value=\"9,81\"/></Analysis></DDA>"), refusal("1:35", "9,81"));
}

}  // namespace keyblock::formats::decimal_comma_test
