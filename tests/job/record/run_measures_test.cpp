// The units of the numbers of a record, by their place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/record/run_measures.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "result/step_record.hpp"

namespace keyblock::run_measures_test {
namespace {

using Json = nlohmann::ordered_json;

const Units kTonnes{"m", "t", "s"};  // force in kN, stress in kPa

}  // namespace

TEST(RunMeasures, numbers_of_a_record_have_the_unit_of_their_place) {
  EXPECT_EQ(measure_in_record("outcome.time"), measures::kTime);
  EXPECT_EQ(measure_in_record("outcome.motion.fastest.speed"), measures::kVelocity);
  EXPECT_EQ(measure_in_record("extremes.least_principal_stress.value"), measures::kStress);
  EXPECT_EQ(measure_in_record("counts.greatest_penetration"), measures::kLength);
  EXPECT_EQ(measure_in_record("plastic.plastic_work"), measures::kEnergy);
  EXPECT_EQ(measure_in_record("reactions[].plateau.since_driven"), measures::kLength);
}

TEST(RunMeasures, settings_and_ledger_have_tables_of_their_own) {
  EXPECT_EQ(measure_in_record("settings.time_step"), measures::kTime);
  EXPECT_EQ(measure_in_record("ledger.end.kinetic"), measures::kEnergy);
  EXPECT_EQ(measure_in_record("ledger.end.angular_momentum"), measures::kAngularMomentum);
  EXPECT_EQ(measure_in_record("ledger.momentum_about[]"), measures::kLength);
}

TEST(RunMeasures, forces_of_a_stage_are_those_of_the_run) {
  for (const char* path : {"loads.x", "springs.y", "supports[].x"}) {
    EXPECT_EQ(measure_in_record(std::string("forces.") + path), measures::kForce) << path;
    EXPECT_EQ(measure_in_record(std::string("stages[].forces.") + path), measures::kForce) << path;
  }
  EXPECT_EQ(measure_in_record("stages[].forces.loads.moment"), measures::kMoment);
  EXPECT_EQ(measure_in_record("stages[].end_time"), measures::kTime);
}

TEST(RunMeasures, places_that_are_not_known_have_none) {
  for (const char* path : {"", "outcome", "outcome.steps", "counts.blocks", "settings.no_such_setting", "time",
                           "outcome.time.value", "stages[].steps[]"})
    EXPECT_FALSE(measure_in_record(path)) << path;
}

TEST(RunMeasures, entries_have_titles) {
  EXPECT_EQ(title_in_record("extremes.greatest_displacement.value"), "Greatest displacement");
  EXPECT_EQ(title_in_record("is_static"), "Static analysis");
  EXPECT_FALSE(measure_in_record("is_static"));
  for (const char* path : {"", "plastic.area", "no.such.entry"}) EXPECT_EQ(title_in_record(path), "") << path;
  const auto title = [](std::size_t i) {
    return title_in_record("counts.steps_by_passes[" + std::to_string(i + 1) + "].steps");
  };
  constexpr auto& kLimits = StepTotals::pass_limits;
  for (std::size_t i = 1; i < kLimits.size(); ++i)
    EXPECT_EQ(title(i), fmt::format("Steps of {} to {} iterations", kLimits[i - 1] + 1, kLimits[i]));
  EXPECT_EQ(title(0), "Steps without iterations");
  EXPECT_EQ(title(kLimits.size()), fmt::format("Steps of more than {} iterations", kLimits.back()));
}

TEST(RunMeasures, the_unit_of_each_number_stands_under_its_path) {
  const Json record = Json::parse(R"({
    "program": "keyblock", "outcome": {"time": 1.5, "steps": 7, "end": "finished"},
    "extremes": {"greatest_displacement": {"value": 0.1, "element": 3},
                 "greatest_principal_stress": {"value": 20, "element": 1}},
    "stages": [{"end_time": 1, "forces": {"loads": {"x": 1, "y": 2, "moment": 3}}}, {"end_time": 2}],
    "reactions": [{"driven": 1, "reaction": 5, "slope": null}],
    "ledger": {"largest_energy": 4, "end": {"momentum_x": 1}, "momentum_about": [1, 2]},
    "settings": {"time_step": 0.001, "dynamics": "standard"}, "plastic": {"plastic_work": null}})");
  const Json expected = Json::parse(R"({
    "outcome.time": "s", "extremes.greatest_displacement.value": "m",
    "extremes.greatest_principal_stress.value": "kPa", "stages[].end_time": "s", "stages[].forces.loads.x": "kN/m",
    "stages[].forces.loads.y": "kN/m", "stages[].forces.loads.moment": "kN·m/m", "reactions[].driven": "m",
    "reactions[].reaction": "kN/m", "ledger.largest_energy": "kN·m/m", "ledger.end.momentum_x": "kN·s/m",
    "ledger.momentum_about[]": "m", "settings.time_step": "s"})");
  EXPECT_EQ(units_of_numbers(record, kTonnes), expected) << units_of_numbers(record, kTonnes).dump(1);
}

TEST(RunMeasures, a_record_without_numbers_has_no_units) {
  EXPECT_EQ(units_of_numbers(Json::object(), kTonnes), Json::object());
  EXPECT_EQ(units_of_numbers(Json::parse(R"({"outcome": {"time": "soon", "steps": 7}})"), kTonnes), Json::object());
}

}  // namespace keyblock::run_measures_test
