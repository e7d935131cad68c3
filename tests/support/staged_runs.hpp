// Builds small scenes of several stages and records their runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/cover_basis.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::support {

inline constexpr double kGravity = 9.81;
inline constexpr double kWeight = 24525;  ///< of `plain_analysis`, per area

struct Told {
  RunOutcome outcome;
  std::vector<Frame> frames;
  std::vector<HistoryRow> rows;
  Ledger ledger;

  const ElementFrame& at_end(int number) const { return *element_of(frames.back(), number - 1); }
};

inline Stage stage_of(int steps, const std::string& name = "") {
  Stage stage;
  stage.name = name;
  stage.steps = steps;
  return stage;
}

inline std::vector<Point> box(Point low, Point high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

inline Told told_of(const Scene& scene) {
  Told told;
  Observer observer;
  observer.on_frame = [&](const Frame& frame) { told.frames.push_back(frame); };
  observer.on_row = [&](const HistoryRow& row) { told.rows.push_back(row); };
  observer.on_ledger = [&](const LedgerRow& row) { told.ledger.rows.push_back(row); };
  told.outcome = run(scene, 1000, observer);
  told.ledger.scope = told.outcome.ledger_scope;
  EXPECT_EQ(told.outcome.reason, "");
  return told;
}

inline Told told_of(const Problem& problem, const std::vector<Override>& overrides = {}) {
  return told_of(prepare(problem, "standard", overrides).scene);
}

/// A fixed base of 4 × 1, with blocks of 2 × 1 on it.
inline Problem column(int blocks, double dt = 1e-3) {
  Problem problem;
  Blocks all;
  all.blocks.push_back(rectangle({-1, -1}, {3, 0}));
  for (int i = 0; i < blocks; ++i) all.blocks.push_back(rectangle({0, 1.0 * i}, {2, i + 1.0}));
  all.fixed_points = {{{-0.5, -0.5}, 0, {}}, {{2.5, -0.5}, 0, {}}};
  problem.geometry = all;
  problem.analysis = plain_analysis(dt, 1);
  problem.analysis->joint_materials[0].friction_angle_deg = 40;
  return problem;
}

/// Two NMM squares, one on the other, the lower one fixed along its base.
inline Problem squares_on_covers(CoverFunctions functions) {
  Problem problem;
  Blocks all;
  all.blocks = {rectangle({0, 0}, {2, 1}), rectangle({0, 1}, {2, 2})};
  problem.geometry = all;
  problem.analysis = plain_analysis(1e-3, 1);
  problem.analysis->joint_materials[0].friction_angle_deg = 40;
  CoverPlan plan;
  plan.functions = functions;
  plan.mesh.side = 0.45;
  plan.displacements = {{{{0, 0}, {2, 0}}, Held::both, {}, {}, {}, {}}};
  problem.covers = plan;
  return problem;
}

/// A wall of bricks in running bond on a fixed base, with an opening excavated in two stages and a bolt placed in
/// between.
inline Problem wall_with_opening() {
  Problem problem = column(0);
  std::vector<BlockPolygon>& blocks = std::get<Blocks>(problem.geometry).blocks;
  blocks = {rectangle({-1, -1}, {9, 0})};
  std::get<Blocks>(problem.geometry).fixed_points[1].position = {8.5, -0.5};
  for (int row = 0; row < 5; ++row)
    for (int i = 0; i < 4 - row % 2; ++i) {
      const double left = 2 * i + row % 2;
      blocks.push_back(rectangle({left, 1.0 * row}, {left + 2, row + 1.0}));
    }
  problem.stages = {stage_of(30), stage_of(30, "heading"), stage_of(30, "bolt"), stage_of(30, "bench")};
  // Through the middle of bricks, so that notched ones are left.
  problem.stages[1].excavations = {{box({3.2, 1.4}, {4.9, 2.5}), 0, {}}};
  problem.stages[2].bolts = {{{{4, 2.8}, {4, 4.5}}, 1e7, 0, 1e4, 0, {}}};
  problem.stages[3].excavations = {{box({3.2, 0}, {4.9, 1.4}), 0, {}}};
  return problem;
}

}  // namespace keyblock::support
