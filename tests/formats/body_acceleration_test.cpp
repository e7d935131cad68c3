// Tables of accelerations are read, and every fault is named with its cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/body_acceleration.hpp"

#include <gtest/gtest.h>

namespace keyblock::formats::formats_body_acceleration_test {
namespace {

std::string complaint(const std::string& text) {
  try {
    read_body_acceleration({"shake.csv", text});
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST(BodyAccelerationTable, columns_are_found_by_name) {
  const TimeCurve curve = read_body_acceleration({"shake.csv", "ay,time,note,ax\n-1,0,a,2\n-3,0.5,b,4\n"});
  EXPECT_EQ(curve.times, (std::vector<double>{0, 0.5}));
  EXPECT_EQ(curve.at(0.25), (Point{3, -2}));
  EXPECT_EQ(curve.place.file, "shake.csv");
}

TEST(BodyAccelerationTable, faults_are_named_with_line_and_column) {
  EXPECT_EQ(complaint("time,ax,ay\n0,1,2\n1,x,2\n"),
            "shake.csv:3:3: error: expected a number in column \"ax\", found \"x\"");
  EXPECT_EQ(complaint("time,ax,ay\n0.5,1,2\n0.5,1,2\n"), "shake.csv:3:1: error: expected a time after 0.5, found 0.5");
  EXPECT_EQ(complaint("time,ax\n0,1\n"), "shake.csv:1:1: error: expected a column \"ay\", found \"time,ax\"");
  EXPECT_EQ(complaint("time,ax,ay\n"), "shake.csv: error: expected a row time,ax,ay below the header, found none");
}

}  // namespace keyblock::formats::formats_body_acceleration_test
