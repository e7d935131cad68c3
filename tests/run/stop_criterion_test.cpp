// A run stops behind the step in which a quantity passes its limit, and goes on from there.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/follow/stop_criterion.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "base/error.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::stop_criterion_test {
namespace {

using support::contains;
using support::fresh_folder;
using support::read_text;
using support::run_keyblock;

const Units kMetres{"m", "kg", "s"};
const std::vector<FollowedValue> kValues{{"point", "crest", "displacement_x", 0.03, "m"},
                                         {"point", "crest", "displacement_y", -0.04, "m"},
                                         {"point", "crest", "velocity_x", 1.5, "m/s"}};

TEST(StopCriterion, limits_have_a_sign_and_a_unit) {
  const StopCriterion above = stop_criterion_of("crest.dx > 5 cm", kMetres);
  EXPECT_EQ(above.history, "crest");
  EXPECT_EQ(above.quantity, "displacement_x");
  EXPECT_TRUE(above.is_above);
  EXPECT_DOUBLE_EQ(above.limit, 0.05);
  EXPECT_FALSE(stop_criterion_of("a.b.force_x<-3", kMetres).is_above);
  EXPECT_EQ(stop_criterion_of("a.b.force_x<-3", kMetres).history, "a.b");
  for (const char* text : {"", "crest", "crest.dx", "crest>1", ".dx>1", "crest.>1", "crest.dx>", "crest.dx>much",
                           "crest.dx>3 s", "crest.force_x>3 kN", "crest.dx>nan"})
    EXPECT_THROW(stop_criterion_of(text, kMetres), std::invalid_argument) << text;
}

TEST(StopCriterion, rows_meet_it_or_not_and_a_missing_quantity_is_an_error) {
  const auto met = [](const char* text) { return stop_criterion_of(text, kMetres).met_by(kValues); };
  EXPECT_EQ(met("crest.d>0.049"), "crest.displacement is 0.05 m, above 0.049 m");
  EXPECT_EQ(met("crest.d>0.051"), "");
  EXPECT_EQ(met("crest.dy<-0.03"), "crest.displacement_y is -0.04 m, below -0.03 m");
  EXPECT_EQ(met("crest.vx<1.5"), "");
  EXPECT_THROW(met("toe.dx>1"), InputError);
  EXPECT_THROW(met("crest.force_x>1"), InputError);
}

TEST(StopCriterion, a_run_stops_there_and_goes_on) {
  const std::string folder = fresh_folder("stop_when"), file = folder + "/block.json", out = folder + "/out";
  run_keyblock({"new", "block", "-o", file});
  const auto run = run_keyblock({"run", file, "-o", out, "--history", "b=block:2", "--stop-when", "b.d>0.2"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(contains(run.messages, "b.displacement is 0.2")) << run.messages;
  const auto record = nlohmann::json::parse(read_text(out + "/run.json"));
  EXPECT_EQ(record["outcome"]["end"], "stopped");
  EXPECT_LT(record["outcome"]["steps"], 100);
  const double moved = record["extremes"]["greatest_displacement"]["value"];
  EXPECT_GT(moved, 0.2);
  EXPECT_LT(moved, 0.22);
  EXPECT_EQ(run_keyblock({"run", "--resume", out}).exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(read_text(out + "/run.json"))["outcome"]["steps"], 100);
}

TEST(StopCriterion, a_criterion_without_its_history_leaves_no_folder) {
  const std::string folder = fresh_folder("stop_without"), file = folder + "/block.json";
  run_keyblock({"new", "block", "-o", file});
  const auto run = run_keyblock({"run", file, "-o", folder + "/out", "--stop-when", "b.d>0.2"});
  EXPECT_EQ(run.exit_code, 3) << run.messages;
  EXPECT_TRUE(contains(run.messages, "expected a quantity of a history")) << run.messages;
  EXPECT_EQ(run_keyblock({"run", file, "-o", folder + "/out", "--stop-when", "b.d"}).exit_code, 2);
}

}  // namespace
}  // namespace keyblock::stop_criterion_test
