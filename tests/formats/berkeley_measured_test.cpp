// Measured points in time: blocks of rows, the zero bytes of the Berkeley program, and files cut off.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/berkeley_measured.hpp"

#include <gtest/gtest.h>

#include "tests/formats/reading.hpp"

namespace keyblock::formats::berkeley_measured_test {
namespace {

const std::string kFirst = "measpoint1=[\n1 .01 .01 5 6 .1 .2 .3 .36\n2 .02 .01 5.5 6.5 .7 1 2 2.24\n];\n";
const std::string kSecond = "measpoint2 = [ 1 .01 .01 7 8 0 0 0 0 ];\n";

}  // namespace

TEST(BerkeleyMeasured, rows_land_in_their_places) {
  const Reading reading = read({"f", kFirst + kSecond});
  EXPECT_EQ(reading.warnings, Warnings{});
  const std::vector<MeasuredTrack> expected{
      {0, {{1, .01, .01, {5, 6}, .1, {.2, .3}, .36}, {2, .02, .01, {5.5, 6.5}, .7, {1, 2}, 2.24}}},
      {1, {{1, .01, .01, {7, 8}, 0, {0, 0}, 0}}}};
  EXPECT_EQ(reading.content.tracks, expected);
}

TEST(BerkeleyMeasured, zero_bytes_between_rows_and_blocks_are_white_space) {
  const std::string hole(40, '\0');
  std::string text = hole + kFirst + hole + kSecond + hole;
  text.insert(text.find("2 .02"), hole);
  EXPECT_EQ(read({"f", text}).content.tracks, read({"f", kFirst + kSecond}).content.tracks);
}

TEST(BerkeleyMeasured, rows_of_a_file_cut_off_are_kept_while_whole) {
  const Reading reading = read({"f", kFirst.substr(0, kFirst.find("2.24"))});
  EXPECT_EQ(names(reading.warnings), std::vector<std::string>{"track_cut"});
  EXPECT_EQ(reading.content.tracks.at(0).rows.size(), 1u);
}

TEST(BerkeleyMeasured, faults_are_named_at_their_place) {
  EXPECT_EQ(error_of("measpoint1=[\n1 .01 .01 5 x 0 0 0 0 ];"), "f:2:13: error: expected y of row 1 of 1, found \"x\"");
  EXPECT_EQ(error_of("measpoint0=[ ];"),
            "f:1:10: error: expected the number of the measured point (a whole number from 1 to 1000000), found \"0\"");
  EXPECT_EQ(error_of(kFirst + "other"), "f:5:1: error: expected a measured point (measpoint1=[), found other text");
}

}  // namespace keyblock::formats::berkeley_measured_test
