// Frames of the public library: their columns, units and epochs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <keyblock/record.hpp>

#include "tests/library/example_cases.hpp"

namespace keyblock::api_test {
namespace {

/// Two bricks beside each other on a floor: a stage excavates the second one, another changes no block.
kb::Case excavated() {
  return wall(2, 1).with("/stages", R"([{"steps": 2}, {"steps": 2, "set": {"time_step": "1 ms"}},
    {"steps": 2, "excavations": [{"outline": [[1, 0], [2, 0], [2, 0.5], [1, 0.5]]}]}, {"steps": 2}])");
}

void expect_epochs(kb::Run& run) {
  while (run.advance()) {
    const kb::Frame now = run.frame();
    const bool is_excavated = now.step() > 4;
    EXPECT_EQ(now.epoch(), is_excavated ? 1 : 0) << now.step();
    EXPECT_EQ(now.number().rows(), is_excavated ? 2U : 3U) << now.step();
  }
  EXPECT_EQ(run.outcome().steps, 8) << run.outcome().reason;
}

}  // namespace

TEST(Frames, columns_of_a_frame_fit_together) {
  kb::Run run((kb::Plan(slide())));
  run.go_on();
  const kb::Frame end = run.frame();
  const auto blocks = end.number().rows();
  ASSERT_GT(blocks, 1U);
  EXPECT_EQ(end.centroid().rows(), blocks);
  EXPECT_EQ(end.stress().width(), 4U);
  std::size_t corners = 0;
  for (const int of_loop : end.loop_corners().values()) corners += static_cast<std::size_t>(of_loop);
  EXPECT_EQ(end.vertices().rows(), corners);
  ASSERT_GT(end.rows("contacts"), 0U);
  EXPECT_EQ(end.contact_pressure().rows(), end.contact_block().rows());
  double pressure = 0;
  for (const double of_contact : end.contact_pressure().values()) pressure += of_contact;
  EXPECT_GT(pressure, 0);
}

TEST(Frames, every_column_that_a_frame_names_is_there_with_its_rows) {
  kb::Run run((kb::Plan(slide())));
  run.go_on();
  const kb::Frame end = run.frame();
  std::size_t columns = 0;
  for (const std::string& part : kb::Frame::parts())
    for (const std::string& name : end.names(part)) {
      const std::size_t rows =
          end.is_integer(part, name) ? end.integers(part, name).rows() : end.reals(part, name).rows();
      EXPECT_EQ(rows, end.rows(part)) << part << " " << name;
      ++columns;
    }
  EXPECT_GT(columns, 25U);
  EXPECT_EQ(end.reals("cracks", "ends").rows(), 0U) << "a part without rows";
  EXPECT_EQ(end.reals("cracks", "ends").width(), 4U) << "it has its columns";
  EXPECT_EQ(code_of([&] { end.reals("cracks", "colour"); }), kb::ErrorCode::choice);
  EXPECT_EQ(code_of([&] { end.reals("cracks", "side"); }), kb::ErrorCode::choice) << "it holds integers";
  EXPECT_EQ(code_of([&] { end.reals("blocks", "colour"); }), kb::ErrorCode::choice);
  EXPECT_EQ(code_of([&] { end.reals("blocks", "material"); }), kb::ErrorCode::choice) << "it holds integers";
  EXPECT_EQ(code_of([&] { end.names("clouds"); }), kb::ErrorCode::choice);
  EXPECT_EQ(code_of([&] { end.unit("blocks", "colour"); }), kb::ErrorCode::choice);
  EXPECT_EQ(end.stress().values().data(), end.reals("blocks", "stress").values().data()) << "one copy for all";
}

// The wall rests on its floor: one contact between two faces with normals along y.
TEST(Frames, contacts_have_place_normal_state_and_forces_of_the_weight) {
  constexpr double kDensity = 2500;
  kb::Run run(kb::Plan(wall(1, 1).with("/analysis/block_materials/0/density", kDensity), {"standard"}));
  run.go_on();
  const kb::Frame end = run.frame();
  const std::size_t contacts = end.rows("contacts");
  ASSERT_GT(contacts, 0U);
  double pressed = 0, sheared = 0;
  for (std::size_t c = 0; c < contacts; ++c) {
    EXPECT_EQ(end.contact_block()(c) + end.contact_other()(c), 3);
    EXPECT_NEAR(end.contact_point()(c, 1), 0, 1e-3);
    EXPECT_NEAR(std::abs(end.contact_normal()(c, 1)), 1, 1e-6);
    EXPECT_NEAR(end.contact_normal()(c, 0), 0, 1e-6);
    EXPECT_GE(end.contact_state()(c), 0);
    EXPECT_LE(end.contact_state()(c), 2);
    if (end.contact_pressure()(c) > 0) {
      EXPECT_EQ(end.contact_state()(c), 1) << "a brick at rest sticks";
    }
    pressed += end.contact_pressure()(c);
    sheared += end.contact_shear()(c);
  }
  const double weight = 0.5 * 9.81 * kDensity;
  EXPECT_NEAR(pressed, weight, 1e-3 * weight);
  EXPECT_NEAR(sheared, 0, 1e-3 * weight);
  EXPECT_EQ(end.load_factor(), 1);
}

TEST(Frames, components_and_units_are_those_of_the_case) {
  const kb::Frame start = kb::Run(kb::Plan(wall(1, 1))).frame();
  EXPECT_EQ(start.components("blocks", "area"), std::vector<std::string>{});
  EXPECT_EQ(start.components("blocks", "displacement"), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(start.components("blocks", "stress"), (std::vector<std::string>{"xx", "yy", "xy", "zz"}));
  EXPECT_EQ(start.components("bolts", "ends"), (std::vector<std::string>{"x1", "y1", "x2", "y2"}));
  EXPECT_EQ(start.unit("blocks", "velocity"), "m/s");
  EXPECT_EQ(start.unit("blocks", "stress"), "Pa");
  EXPECT_EQ(start.unit("contacts", "normal_force"), "N/m");
  EXPECT_EQ(start.unit("blocks", "material"), "");
  EXPECT_EQ(code_of([&] { start.components("blocks", "nonsense"); }), kb::ErrorCode::choice);
  EXPECT_EQ(code_of([&] { start.unit("blocks", "nonsense"); }), kb::ErrorCode::choice);
  EXPECT_EQ(code_of([&] { start.unit("clouds", "x"); }), kb::ErrorCode::choice);
}

TEST(Frames, an_epoch_begins_where_a_stage_excavates) {
  kb::Run run((kb::Plan(excavated())));
  EXPECT_EQ(run.frame().epoch(), 0);
  expect_epochs(run);
}

TEST(Frames, a_resumed_run_counts_on_its_epochs) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "keyblock_epochs";
  std::filesystem::remove_all(folder);
  kb::Run first = kb::recorded(excavated(), folder.string(), {.pictures = false});
  first.go_on([](const kb::Run& now) { return now.last().number == 5; });
  EXPECT_EQ(first.frame().epoch(), 1);
  kb::Run second = kb::resumed(folder.string());
  EXPECT_EQ(second.frame().epoch(), 1);
  expect_epochs(second);
  std::filesystem::remove_all(folder);
}

}  // namespace keyblock::api_test
