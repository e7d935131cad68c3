// A formula is a number or an expression of the place, and has access to nothing else.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/formula.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace keyblock::formula_test {
namespace {

constexpr std::array<std::string_view, 2> kPlace{"x", "y"};

double value_of(const std::string& text, double x, double y) {
  return Compiled({text, {}}, kPlace)({x, y});
}

std::string fault_of(const std::string& text) {
  try {
    Compiled({text, {"f", 3, 10}}, kPlace);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(Formula, a_number_is_itself) {
  EXPECT_EQ(value_of("-1.5e3", 7, 8), -1500);
  EXPECT_TRUE(Compiled({"0", {}}, kPlace).is_zero());
  EXPECT_FALSE(Compiled({"0*x", {}}, kPlace).is_zero());
  EXPECT_TRUE(is_number({"2", {}}));
  EXPECT_FALSE(is_number({"2 ", {}}));
}

TEST(Formula, an_expression_is_computed_at_the_place) {
  EXPECT_DOUBLE_EQ(value_of("2*x^2 - y/4", 3, 8), 16);
  EXPECT_DOUBLE_EQ(value_of("sin(_pi*x)", 0.5, 0), 1);
  EXPECT_DOUBLE_EQ(value_of("x >= 1 && y < 0 ? 5 : sqrt(y)", 0, 9), 3);
  EXPECT_DOUBLE_EQ(value_of("atan2(y, x)", -1, 0), std::numbers::pi);
}

TEST(Formula, copies_keep_their_values_apart_in_turn) {
  const Compiled one({"x + y", {}}, kPlace);
  const Compiled same = one;
  EXPECT_EQ(one({1, 2}), 3);
  EXPECT_EQ(same({5, 6}), 11);
  EXPECT_EQ(one({1, 2}), 3);
}

TEST(Formula, what_makes_no_sense_is_named_at_its_character) {
  EXPECT_EQ(fault_of("x + z"), "f:3:15: error: expected a number or an expression in x, y, found \"z\"");
  EXPECT_EQ(fault_of("x = 1"), "f:3:13: error: expected a number or an expression in x, y, found an assignment");
  EXPECT_EQ(fault_of("x == 1 ? 2 : 3"), "");
  EXPECT_NE(fault_of(""), "");
  EXPECT_NE(fault_of("(x"), "");
  EXPECT_NE(fault_of("1, 2"), "");
  EXPECT_NE(fault_of("x y"), "");
  EXPECT_EQ(
      fault_of("1" + std::string(10000, ' ')),
      "f:3:11: error: expected a number or an expression in x, y, found one of 10001 characters, more than 10000");
  EXPECT_NE(fault_of("\"text\""), "");
}

TEST(Formula, a_value_that_is_not_finite_is_refused_where_it_is_asked_for) {
  const Compiled formula({"1/x", {"f", 3, 10}}, kPlace);
  EXPECT_EQ(formula({2, 0}), 0.5);
  try {
    formula({0, 1});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "f:3:10: error: expected a finite value of \"1/x\" at x = 0, y = 1, found inf");
  }
}

}  // namespace keyblock::formula_test
