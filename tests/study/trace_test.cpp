// A trace agrees only if every value in it was compared and is near: nothing missing, no value that is not finite.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/cases/trace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::study::trace_test {
namespace {

namespace fs = std::filesystem;

/// The free fall trace, with one of its tables changed line by line: `keep` chooses the lines that stay.
TraceDifference follow_with(const std::string& table, const std::function<bool(const std::string&)>& keep) {
  const fs::path folder = fs::path(support::fresh_folder("trace")) / "freefall_dt5ms";
  fs::copy(KEYBLOCK_SOURCE_DIR "/legacy_cases/reference_traces/freefall_dt5ms", folder);
  std::istringstream lines(support::read_text(folder / table));
  std::string header;
  std::getline(lines, header);
  std::string kept = header + "\n";
  for (std::string line; std::getline(lines, line);)
    if (keep(line)) kept += line + "\n";
  support::write_text(folder / table, kept);
  return follow_trace(find_cases({folder.string()}).front());
}

TraceDifference sound() {
  TraceDifference difference;
  difference.steps = difference.steps_in_trace = 10;
  difference.rows = 10;
  return difference;
}

bool begins_with(const std::string& line, const std::string& start) {
  return line.rfind(start, 0) == 0;
}

}  // namespace

TEST(TraceDifference, holds_only_within_the_tolerance) {
  EXPECT_TRUE(sound().holds());
  for (double TraceDifference::*part :
       {&TraceDifference::polygon, &TraceDifference::position, &TraceDifference::rotation, &TraceDifference::stress}) {
    TraceDifference off = sound();
    off.*part = 0.99 * kTraceTolerance;
    EXPECT_TRUE(off.holds());
    off.*part = 1.01 * kTraceTolerance;
    EXPECT_FALSE(off.holds());
  }
  TraceDifference unequal = sound();
  unequal.unequal = {"closed in step 3: 1 for 2"};
  EXPECT_FALSE(unequal.holds());
  EXPECT_FALSE(TraceDifference{}.holds()) << "nothing was compared";
}

TEST(TraceDifference, that_is_not_a_number_does_not_hold) {
  EXPECT_TRUE(sound().holds());
  const std::pair<const char*, double TraceDifference::*> parts[] = {{"polygon", &TraceDifference::polygon},
                                                                     {"position", &TraceDifference::position},
                                                                     {"rotation", &TraceDifference::rotation},
                                                                     {"stress", &TraceDifference::stress}};
  for (const auto& [name, part] : parts) {
    TraceDifference off = sound();
    off.*part = std::nan("");
    EXPECT_FALSE(off.holds()) << name;
  }
}

TEST(FollowTrace, the_trace_as_it_is_holds) {
  const TraceDifference difference = follow_with("steps.csv", [](const std::string&) { return true; });
  EXPECT_TRUE(difference.holds());
  EXPECT_EQ(difference.steps, 400);
}

TEST(FollowTrace, a_blocks_table_without_rows_does_not_hold) {
  EXPECT_FALSE(follow_with("blocks.csv", [](const std::string&) { return false; }).holds());
}

TEST(FollowTrace, a_blocks_table_that_lacks_one_block_does_not_hold) {
  const auto is_of_first = [](const std::string& line) {
    const std::size_t block = line.find(',', line.find(',') + 1) + 1;
    return begins_with(line.substr(block), "1,");
  };
  EXPECT_FALSE(follow_with("blocks.csv", is_of_first).holds());
}

TEST(FollowTrace, a_steps_table_that_lacks_a_row_in_the_middle_does_not_hold) {
  const auto is_other = [](const std::string& line) { return !begins_with(line, "200,"); };
  EXPECT_FALSE(follow_with("steps.csv", is_other).holds());
}

TEST(FollowTrace, a_steps_table_that_breaks_off_does_not_hold) {
  const auto is_early = [](const std::string& line) { return std::stoi(line) <= 100; };
  EXPECT_FALSE(follow_with("steps.csv", is_early).holds()) << "blocks.csv goes on to step 400";
}

TEST(FollowTrace, a_polygon_table_that_lacks_a_block_does_not_hold) {
  EXPECT_FALSE(follow_with("cut_blocks.csv", [](const std::string& line) { return begins_with(line, "1,"); }).holds());
}

}  // namespace keyblock::study::trace_test
