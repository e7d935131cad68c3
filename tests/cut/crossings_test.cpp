// Crossings of lines: their pairs, their places, their order along each line; the effect of the reach.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/crossings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cut/drawings.hpp"

namespace keyblock::crossings_test {
namespace {

CutTolerances exact() {
  return {};
}

CutTolerances of_a_file(const std::vector<Segment>& lines) {
  return cut_tolerances(drawing_of(lines));
}

/// Returns the numbers of the other lines that a line meets, in order along it.
std::vector<int> met_along(const Crossings& crossings, int line) {
  std::vector<int> others;
  for (std::size_t k = crossings.first_stop[line]; k < crossings.first_stop[line + 1]; ++k) {
    const Crossing& c = crossings.found[crossings.stops[k].crossing];
    others.push_back(c.line == line ? c.other : c.line);
  }
  return others;
}

}  // namespace

TEST(Crossings, are_found_once_by_higher_then_lower_line) {
  const std::vector<Segment> lines{{{0, 0}, {10, 0}}, {{1, -1}, {1, 1}}, {{0, 0.5}, {10, 0.5}}, {{2, 5}, {3, 6}}};
  const Crossings crossings = find_crossings(lines, exact());
  ASSERT_EQ(crossings.found.size(), 2U);
  EXPECT_EQ(crossings.found[0].line, 1);
  EXPECT_EQ(crossings.found[0].other, 0);
  EXPECT_EQ(crossings.found[0].position, (Point{1, 0}));
  EXPECT_EQ(crossings.found[1].line, 2);
  EXPECT_EQ(crossings.found[1].other, 1);
  EXPECT_EQ(crossings.found[1].position, (Point{1, 0.5}));
}

TEST(Crossings, stand_along_each_line_in_its_own_direction) {
  const std::vector<Segment> lines{
      {{10, 0}, {0, 0}}, {{3, -1}, {3, 1}}, {{1, -1}, {1, 1}}, {{2, 1}, {2, -1}}, {{5, 0}, {5, 2}}};
  const Crossings crossings = find_crossings(lines, exact());
  EXPECT_EQ(met_along(crossings, 0), (std::vector<int>{4, 1, 3, 2}));
  EXPECT_TRUE(crossings.equal_before.empty());
}

// Three lines through (1/3, 1/3), which no double is.
TEST(Crossings, that_coincide_exactly_are_told_so) {
  std::vector<Segment> lines{{{0, 0}, {1, 1}}, {{0, 1}, {1, -1}}, {{0, -1}, {1, 3}}};
  const Crossings crossings = find_crossings(lines, exact());
  EXPECT_EQ(crossings.found.size(), 3U);
  EXPECT_EQ(crossings.equal_before.size(), 3U) << "the second stop on each of the three";
  lines[2].end.x = std::nextafter(1, 2);
  const Crossings beside = find_crossings(lines, exact());
  EXPECT_EQ(beside.found.size(), 3U);
  EXPECT_TRUE(beside.equal_before.empty());
}

// Legacy-rules 15: start + t (end - start) of the higher-numbered line.
TEST(Crossings, are_evaluated_on_the_higher_numbered_line) {
  const Segment upright{{1.1, -1}, {1.1, 2}};
  const Segment flat{{0.1, 0}, {3.1, 0}};
  const Point on_upright = find_crossings(std::vector{flat, upright}, exact()).found[0].position;
  EXPECT_EQ(on_upright.x, 1.1) << "x is that of the upright line to the last bit";
  const Point on_flat = find_crossings(std::vector{upright, flat}, exact()).found[0].position;
  EXPECT_EQ(on_flat.y, 0) << "y is that of the flat line to the last bit";
}

TEST(Crossings, lines_along_each_other_meet_in_the_ends_that_lie_on_the_other) {
  const std::vector<Segment> lines{{{0, 0}, {4, 0}}, {{3, 0}, {9, 0}}};
  const Crossings crossings = find_crossings(lines, exact());
  ASSERT_EQ(crossings.found.size(), 2U);
  EXPECT_TRUE(crossings.found[0].is_end);
  EXPECT_EQ(crossings.found[0].position, (Point{4, 0})) << "the lower line's end first";
  EXPECT_EQ(crossings.found[1].position, (Point{3, 0}));
  EXPECT_EQ(find_crossings(std::vector<Segment>{{{0, 0}, {4, 0}}, {{5, 0}, {9, 0}}}, exact()).found.size(), 0U);
  EXPECT_EQ(find_crossings(std::vector<Segment>{{{0, 0}, {4, 0}}, {{4, 0}, {9, 0}}}, exact()).found.size(), 1U);
}

// The reach is 1e-7 of the length of the line that falls short: here 1e-6.
TEST(Crossings, a_line_that_falls_short_by_less_than_the_reach_is_taken_to_meet) {
  const auto short_by = [](double gap) { return std::vector<Segment>{{{-5, 0}, {5, 0}}, {{0, 10}, {0, gap}}}; };
  const Crossings reached = find_crossings(short_by(5e-7), of_a_file(short_by(5e-7)));
  ASSERT_EQ(reached.found.size(), 1U);
  EXPECT_TRUE(reached.found[0].is_reached);
  EXPECT_NEAR(reached.found[0].position.y, 0, 1e-14);
  EXPECT_TRUE(find_crossings(short_by(2e-6), of_a_file(short_by(2e-6))).found.empty());
  EXPECT_TRUE(find_crossings(short_by(5e-7), exact()).found.empty());
}

}  // namespace keyblock::crossings_test
