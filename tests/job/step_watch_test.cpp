// Messages about steps: each once, with the first step that it concerns.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "formats/case.hpp"
#include "job/run_warnings.hpp"
#include "run/prepare.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::step_watch_test {
namespace {

Prepared square_that_yields() {
  const std::string file = support::fresh_folder("step_watch") + "/in.json";
  support::write_text(file, R"({"keyblock": 1, "blocks": {"blocks": [
    {"outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]}]}, "covers": {"mesh": {"side": 0.5},
    "displacements": [{"along": [[0, 0], [1, 0]]}]}, "analysis": {"step_count": 8, "time_step": 1,
    "allowed_displacement_ratio": 0.1, "plane_strain": true, "velocity_carry_over": 0, "joint_materials": [{}],
    "block_materials": [{"density": 1, "unit_weight": 0, "youngs_modulus": 1e4, "poissons_ratio": 0.3,
    "strength": {"cohesion": 10}}]}})");
  return prepare(formats::load_case({file}).problem, "standard", {});
}

Warnings told(const Prepared& prepared, const std::vector<int>& parts) {
  StepWatch watch(prepared);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    StepReport report;
    report.step = static_cast<int>(i) + 1;
    report.parts = parts[i];
    watch.add(report);
  }
  Warnings found = watch.warnings({});
  std::erase_if(found, [](const Warning& warning) { return warning.name != "step_in_parts"; });
  return found;
}

}  // namespace

TEST(StepWatch, a_load_step_of_many_parts_is_warned_of_once) {
  const Prepared prepared = square_that_yields();
  EXPECT_TRUE(told(prepared, {1, 1, 2, 3}).empty());
  const Warnings found = told(prepared, {1, 3, 7, 1, 9});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].sentence,
            "step 3 was made in 7 parts, near a limit load or too long for elastoplastic rock; as in 2 of 5 steps");
}

// Two of 3 steps out of balance by more than 1e-6 stay below 1e-4.
TEST(StepWatch, forces_out_of_balance_are_told_by_the_worst_step_with_its_contact) {
  StepWatch watch(square_that_yields());
  const double residuals[] = {2e-6, 1e-9, 7e-4, 3e-5};
  for (int i = 0; i < 4; ++i) {
    StepReport report;
    report.step = i + 1;
    report.time = 0.5 * report.step;
    report.residual = residuals[i];
    report.residual_element = 10 + i;
    report.residual_other = 20 + i;
    report.residual_at = {1.5, -2};
    report.contacts = 40;
    report.closed = 30;
    watch.add(report);
  }
  const Warnings found = watch.warnings({});
  const auto told = std::ranges::find(found, "large_residual", &Warning::name);
  const auto noted = std::ranges::find(found, "residual_above_goal", &Warning::name);
  ASSERT_NE(told, found.end());
  ASSERT_NE(noted, found.end());
  EXPECT_TRUE(noted->sentence.starts_with("forces are out of balance by more than 1e-06 of the load in 2 of 4 steps"));
  EXPECT_EQ(told->sentence,
            "forces are out of balance by more than 1e-04 of the load in 1 of 4 steps; the worst is step 3 (time 1.5), "
            "by 7.0e-04, at the contact of element 12 with element 22 near 1.5, -2 (40 contacts in all, 30 closed)");
}

TEST(StepWatch, bolts_that_break_on_the_way_are_named) {
  const BoltFrame whole{{0, 0}, {1, 0}, 1, false, 0, "B1"}, other{{0, 1}, {1, 1}, 1, false, 4};
  BoltFrame broken = whole, also = other;
  broken.is_broken = also.is_broken = true;
  Frame first, last;
  first.bolts = {whole, other};
  last.bolts = {broken, other};
  EXPECT_TRUE(broken_bolts(first, first, {}).empty());
  ASSERT_EQ(broken_bolts(first, last, {}).size(), 1u);
  EXPECT_EQ(broken_bolts(first, last, {})[0].sentence, "1 of 2 bolts broke: 1 \"B1\"; bolts.csv has the frame");
  first.bolts = {broken};
  EXPECT_TRUE(broken_bolts(first, last, {}).empty()) << "broken in the initial state, which is reported before the run";
  last.bolts = {broken, also};
  EXPECT_NE(broken_bolts(first, last, {})[0].sentence.find("broke: 5;"), std::string::npos);
}

}  // namespace keyblock::step_watch_test
