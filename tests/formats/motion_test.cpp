// Ground motions in both formats, and their difference from other files of numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/motion.hpp"

#include <gtest/gtest.h>

#include "tests/formats/reading.hpp"

namespace keyblock::formats::formats_motion_test {
namespace {

const std::string kShake = "some quake, E-W, in g\n10 0.02 (8F9.6)\n 0 .1 .2 .3 .4 .5 .6 .7\n .8 -.9\n";

}  // namespace

TEST(Motion, shake_has_two_header_lines_and_a_fixed_time_step) {
  const Reading reading = read({"f", kShake});
  EXPECT_EQ(reading.warnings, Warnings{});
  const TimeCurve& motion = *reading.content.motion;
  ASSERT_EQ(motion.times.size(), 10u);
  EXPECT_EQ(motion.times[9], 0.18);
  EXPECT_EQ(motion.values[9], (Point{-.9, 0}));
  EXPECT_EQ(motion.place.file, "f");
  EXPECT_EQ(read({"f", "# " + kShake}).content.motion->times.size(), 10u);
}

TEST(Motion, matlab_states_its_time_step_before_the_values) {
  const TimeCurve motion = *read({"f", "0.005 3\n.1\n-.2\n.3\n"}).content.motion;
  EXPECT_EQ(motion.times, (std::vector<double>{0, 0.005, 0.01}));
  EXPECT_EQ(motion.values[1], (Point{-.2, 0}));
}

TEST(Motion, fewer_values_than_announced_are_an_error) {
  const auto complaint = [](const Format& format, const std::string& text) {
    try {
      format.read({"f", text}, {});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint(kMotionMatlab, "0.005 4\n.1\n-.2\n.3\n"),
            "f:1:7: error: expected the number of values (at most 3: so many values follow), found \"4\"");
  EXPECT_EQ(complaint(kMotionShake, kShake.substr(0, kShake.size() - 5)),
            "f:4:4: error: expected the acceleration of value 10 of 10, found end of file");
  EXPECT_EQ(complaint(kMotionShake, "one line"), "f:1:9: error: expected the number of values, found end of line");
}

TEST(Motion, other_files_of_numbers_are_not_taken_for_motions) {
  EXPECT_EQ(recognise({"f", "0.01\n3 0\n0\n0\n"}).format->name, "dda-geometry");
  EXPECT_EQ(recognise({"f", "1 3 1\n1\n1\n"}).format->name, "dda-analysis-berkeley");
}

}  // namespace keyblock::formats::formats_motion_test
