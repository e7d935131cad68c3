// Replay files: frames of moving blocks, rows without meaning that are skipped, and a last frame cut off.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/berkeley_replay.hpp"

#include <gtest/gtest.h>

#include "tests/formats/reading.hpp"

namespace keyblock::formats::berkeley_replay_test {
namespace {

/// One frame: the unit square shifted by (x, 0), a bolt along its base, a fixed and a measured point.
std::string frame(const std::string& x, const std::string& x1) {
  return "-6277 0.000000 1e30\n1 " + x + " 0\n2 " + x1 + " 0\n1 " + x1 + " 1\n1 " + x + " 1\n1 " + x +
         " 0\n0 9 9\n0 9 9\n0 9 9\n" + x + " 0 " + x1 + " 0 1 1 1e6 2e3 50\n7 7 7 7\n0 " + x + " 0 1\n1 " + x1 +
         " 1 1\n";
}

const std::string kHead = "2 1 1 8\n1 0 1\n99 -5 4\n3 1 4\n";
const std::string kFile = kHead + frame("0", "1") + frame("0.25", "1.25") + frame("0.5", "1.5");

}  // namespace

TEST(BerkeleyReplay, frames_hold_blocks_points_and_bolts_where_they_stood) {
  const Reading reading = read({"f", kFile});
  EXPECT_EQ(reading.warnings, Warnings{});
  const std::vector<Frame>& frames = reading.content.frames;
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[2].step, 2);
  ASSERT_EQ(frames[2].elements.size(), 1u);
  const ElementFrame& block = frames[2].elements[0];
  EXPECT_EQ(block.loops[0], (std::vector<Point>{{0.5, 0}, {1.5, 0}, {1.5, 1}, {0.5, 1}}));
  EXPECT_EQ(block.material, 2);
  EXPECT_EQ(block.area, 1);
  EXPECT_EQ(block.centroid, (Point{1, 0.5}));
  EXPECT_EQ(block.displacement, (Point{0.5, 0}));
  EXPECT_EQ(frames[1].fixed_points.at(0).displacement, (Point{0.25, 0}));
  EXPECT_EQ(frames[1].measured_points.at(0).position, (Point{1.25, 1}));
  EXPECT_EQ(frames[1].measured_points.at(0).element, 0);
  EXPECT_EQ(frames[1].bolts.at(0).second, (Point{1.25, 0}));
}

TEST(BerkeleyReplay, last_frame_cut_off_is_left_out_with_a_warning) {
  const Reading reading = read({"f", kFile.substr(0, kFile.size() - 10)});
  EXPECT_EQ(names(reading.warnings), std::vector<std::string>{"frames_missing"});
  EXPECT_EQ(reading.content.frames.size(), 2u);
}

TEST(BerkeleyReplay, first_frame_cut_off_is_an_error_where_it_ends) {
  EXPECT_EQ(error_of(kHead + "0 0 0\n1 0"),
            "f:6:4: error: expected y of a vertex slot of frame 1 of 1, found end of file");
}

TEST(BerkeleyReplay, counts_of_a_thousand_million_take_no_memory) {
  EXPECT_NE(error_of("2000000000 1 2000000000 2000000000\n2000000000 0 1\n0 0 0\n1 1 1999999996\n0 0 0\n1 2 3\n"), "");
}

TEST(BerkeleyReplay, points_of_blocks_that_are_not_there_are_errors) {
  std::string text = kFile;
  text.replace(text.find("0 0 0 1\n1 1 1 1"), 7, "0 0 0 2");
  EXPECT_EQ(error_of(text).substr(0, 20), "f:16:7: error: expec");
}

}  // namespace keyblock::formats::berkeley_replay_test
