// Every setting has an effect on every kind of body, or a warning or an error says that it has none.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "result/describe.hpp"
#include "run/checkpoint.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::every_setting_test {
namespace {

using support::plain_analysis;
using support::rectangle;

enum class Kind { blocks, statics, covers, cover_statics, linear };

/// A block that meets its base and slides, a bonded pair beside it, a bolt, a load; two materials of each kind.
Problem scene(Kind kind) {
  const bool is_static = kind == Kind::statics || kind == Kind::cover_statics || kind == Kind::linear;
  Problem problem;
  Blocks all;
  all.blocks = {rectangle({-2, -1}, {6, 0}), rectangle({0, is_static ? 0 : 0.002}, {2, is_static ? 1 : 1.002}),
                rectangle({3, 0}, {5, 1}), rectangle({3, 1}, {5, 2})};
  for (BlockVertex& vertex : all.blocks[3].outer) vertex.joint_material = 1;
  all.blocks[1].material = 1;
  all.loading_points = {{{4, 1.5}, 3, {}}};
  all.measured_points = {{{1, 0.5}, 1, {}}, {{4, 1.5}, 3, {}}};
  if (!is_static) all.bolts = {{{{1, 0.5}, {4, 1.5}}, 1, 3, 1e6, 0, 100, {}}};
  if (kind == Kind::blocks || kind == Kind::statics) all.fixed_points = {{{-1, -0.5}, 0, {}}, {{5, -0.5}, 0, {}}};
  Analysis analysis = plain_analysis(2e-3, is_static ? 3 : kind == Kind::covers ? 2 : 12);
  analysis.velocity_carry_over = is_static ? 0 : 1;
  analysis.block_materials[0].youngs_modulus = 2e8;
  analysis.block_materials.push_back(analysis.block_materials[0]);
  analysis.block_materials[1].initial_velocity = {0.3, -1, 0.2};
  analysis.block_materials[1].unit_weight *= 1.1;  // not density times gravity
  analysis.joint_materials[0].friction_angle_deg = 30;
  analysis.joint_materials.push_back({20, 2e4, 1e4, {}});
  analysis.point_loads = {{{0, 1}, {{1e4, 0}, {2e4, 0}}, {}}};
  if (kind != Kind::blocks && kind != Kind::statics) {
    CoverPlan plan;
    plan.functions = CoverFunctions::constant;
    plan.mesh.side = 2.6;
    plan.displacements = {{{{-2, -1}, {6, -1}}, Held::both, {}, {}, {}, {}}};
    if (kind == Kind::linear) plan.contact = CoverContact::ignored;
    problem.covers = plan;
  }
  if (kind == Kind::linear) {
    all.blocks.resize(1);
    all.loading_points.clear();
    all.measured_points = {{{1, -0.5}, 0, {}}};
    analysis.point_loads.clear();
  }
  problem.geometry = all;
  problem.analysis = analysis;
  return problem;
}

/// All reports of a run, and the messages about its settings.
struct Answer {
  std::string bytes;
  Warnings warnings;
};

Answer answer(const Problem& problem, const std::vector<Override>& overrides) {
  const Prepared prepared = prepare(problem, "standard", overrides);
  Archive archive;
  Observer observer;
  observer.on_frame = [&](Frame frame) { archive.group("frame", [&] { describe(archive, frame); }); };
  observer.on_row = [&](HistoryRow row) { archive.group("row", [&] { describe(archive, row); }); };
  observer.on_step = [&](StepReport report) { archive.group("step", [&] { describe(archive, report); }); };
  observer.on_ledger = [&](LedgerRow row) { archive.group("ledger", [&] { describe(archive, row); }); };
  RunOutcome outcome = run(prepared.scene, 1, observer);
  archive.value("reason", outcome.reason);
  archive.value("made", outcome.start.made);
  return {checkpoint_bytes(archive), prepared.warnings};
}

/// Values to try: other words of a choice, or numbers near the present one and of other sizes.
std::vector<std::string> values_for(const SettingText& setting) {
  std::vector<std::string> values;
  if (!setting.is_number) {
    if (setting.permitted.words.empty()) return {"acceleration.csv"};
    values = setting.permitted.words;
  }
  for (const char* number : {"0.37", "0.75", "2", "7", "1e7", "-4", "1e-9"}) values.emplace_back(number);
  std::erase(values, setting.value);
  return values;
}

// Effects that the scene cannot show, with the reason.
const std::set<std::string> kNotShown{"penetration_limit",
                                      "crushing_limit",
                                      "energy_limit",         // of the record, not the run
                                      "allowed_penetration",  // of warnings
                                      "force_tolerance",      // more than 50 contacts
                                      "corner_rounding",      // crossing joints
                                      "ledger",
                                      "dynamics"};

const char* name_of(Kind kind) {
  static constexpr std::array kNames{"blocks", "statics", "covers", "cover_statics", "linear"};
  return kNames[static_cast<std::size_t>(kind)];
}

class EverySetting : public testing::TestWithParam<Kind> {};

}  // namespace

TEST_P(EverySetting, has_an_effect_or_is_said_to_have_none) {
  const Problem problem = scene(GetParam());
  int settings = 0;
  for (const SettingText& setting : list(settings_of(problem, "standard", {}))) {
    if (kNotShown.contains(setting.name)) continue;
    const Answer before = answer(problem, {});
    std::string silent;
    bool is_heard = false;
    for (const std::string& value : values_for(setting)) {
      try {
        const Answer after = answer(problem, {{setting.name, value}});
        const bool is_said = std::ranges::any_of(after.warnings, [&](const Warning& warning) {
          return warning.name == "setting_without_effect" && warning.sentence.find(setting.name) != std::string::npos;
        });
        EXPECT_TRUE(!is_said || after.bytes == before.bytes) << setting.name << " = " << value << " has an effect";
        is_heard = is_said || after.bytes != before.bytes;
        if (!is_heard) silent = value;
      } catch (const std::exception&) {  // a refused value has its message, but shows no effect
      }
      if (is_heard) break;
    }
    ++settings;
    EXPECT_TRUE(is_heard || silent.empty()) << setting.name << " = " << silent;
  }
  EXPECT_GT(settings, 50);
}

INSTANTIATE_TEST_SUITE_P(Kinds, EverySetting,
                         testing::Values(Kind::blocks, Kind::statics, Kind::covers, Kind::cover_statics, Kind::linear),
                         [](const auto& one) { return std::string(name_of(one.param)); });

}  // namespace keyblock::every_setting_test
