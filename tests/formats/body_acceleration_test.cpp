// Tables of accelerations are read, and every fault is named with its cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/body_acceleration.hpp"

#include <gtest/gtest.h>

namespace keyblock::formats::formats_body_acceleration_test {
namespace {

std::string complaint(const std::string& text, const Units& units = {}) {
  try {
    read_body_acceleration({"shake.csv", text}, units);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST(BodyAccelerationTable, columns_are_found_by_name) {
  const TimeCurve curve = read_body_acceleration({"shake.csv", "ay,time,note,ax\n-1,0,a,2\n-3,0.5,b,4\n"}, {});
  EXPECT_EQ(curve.times, (std::vector<double>{0, 0.5}));
  EXPECT_EQ(curve.at(0.25), (Point{3, -2}));
  EXPECT_EQ(curve.place.file, "shake.csv");
}

// One record serves cases in any units. A heading with a unit was read as one without.
TEST(BodyAccelerationTable, units_of_headings_become_those_of_the_case) {
  const std::string text = "time [ms],ax [g],ay [m/s2]\n0,0.5,3\n20,-1,0\n";
  const TimeCurve in_mm = read_body_acceleration({"shake.csv", text}, {"mm", "t", "s"});
  EXPECT_EQ(in_mm.times, (std::vector<double>{0, 0.02}));
  EXPECT_DOUBLE_EQ(in_mm.values[0].x, 4903.325);
  EXPECT_DOUBLE_EQ(in_mm.values[1].x, -9806.65);
  EXPECT_DOUBLE_EQ(in_mm.values[0].y, 3000);
  EXPECT_EQ(read_body_acceleration({"shake.csv", "time [s],ax [m/s2],ay\n0.02,0.3,1\n"}, {"m", "kg", "s"}).values[0],
            (Point{0.3, 1}));
  EXPECT_EQ(complaint("time [m],ax,ay\n0,1,2\n", {"m", "kg", "s"}),
            "shake.csv:1:1: error: expected a unit of time, such as s, found \"time [m]\"");
  EXPECT_EQ(complaint("time,ax [kN],ay\n0,1,2\n", {"m", "kg", "s"}),
            "shake.csv:1:1: error: expected a unit of acceleration, such as m/s2 or g, found \"ax [kN]\"");
  EXPECT_EQ(
      complaint("time,ax [m/s2],ay\n0,1,2\n"),
      "shake.csv:1:1: error: expected the heading \"ax\", because the case declares no units, found \"ax [m/s2]\"");
}

TEST(BodyAccelerationTable, faults_are_named_with_line_and_column) {
  EXPECT_EQ(complaint("time,ax,ay\n0,1,2\n1,x,2\n"),
            "shake.csv:3:3: error: expected a number in column \"ax\", found \"x\"");
  EXPECT_EQ(complaint("time,ax,ay\n0.5,1,2\n0.5,1,2\n"), "shake.csv:3:1: error: expected a time after 0.5, found 0.5");
  EXPECT_EQ(complaint("time,ax\n0,1\n"), "shake.csv:1:1: error: expected a column \"ay\", found \"time,ax\"");
  EXPECT_EQ(complaint("time,ax,ay\n"), "shake.csv: error: expected a row time,ax,ay below the header, found none");
}

}  // namespace keyblock::formats::formats_body_acceleration_test
