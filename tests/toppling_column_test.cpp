// The expected rotations of the toppling column are those of a rigid column about its toe, integrated here anew.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "formats/case.hpp"
#include "formats/text/csv.hpp"

namespace keyblock::toppling_column_test {
namespace {

constexpr double kGravity = 9.81;
constexpr double kSlope = 20 * std::numbers::pi / 180;
constexpr double kWidth = 1;
constexpr double kEnd = 1;  // s
constexpr int kSteps = 20000;

/// theta: from the vertical to the line from toe to centroid, downhill positive.
struct Motion {
  double theta = 0;
  double rate = 0;
};

Motion operator+(Motion a, Motion b) {
  return {a.theta + b.theta, a.rate + b.rate};
}
Motion operator*(double s, Motion a) {
  return {s * a.theta, s * a.rate};
}

/// A rectangle b × h of unit mass about its corner: moment of inertia (b² + h²)/3, arm of the weight half the diagonal.
struct Column {
  double width;
  double height;

  Motion change(Motion m) const {
    const double square = width * width + height * height;
    return {m.rate, kGravity * std::sqrt(square) / 2 * std::sin(m.theta) / (square / 3)};
  }

  /// One step of the fourth-order Runge-Kutta rule.
  Motion next(Motion m, double dt) const {
    const Motion k1 = change(m);
    const Motion k2 = change(m + dt / 2 * k1);
    const Motion k3 = change(m + dt / 2 * k2);
    const Motion k4 = change(m + dt * k3);
    return m + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
};

/// How far the column has turned clockwise (downhill) at `time`.
double turned(const Column& column, double time, int steps) {
  const double first = kSlope - std::atan(column.width / column.height);  // standing square on the slope
  Motion motion{first, 0};
  for (int i = 0; i < steps; ++i) motion = column.next(motion, time / steps);
  return motion.theta - first;
}

const Column kFalling{kWidth, kWidth / (0.5 * std::tan(kSlope))};

}  // namespace

TEST(TopplingColumn, expected_rotations_are_those_of_the_rigid_column_in_every_printed_digit) {
  const formats::CsvTable table =
      formats::read_csv(formats::load(KEYBLOCK_SOURCE_DIR "/legacy_cases/toppling_column/falls/expected.csv"));
  const auto cell = [&](const formats::CsvRow& row, const char* name) {
    return row.cells[formats::csv_column(table, name)];
  };
  int rotations = 0;
  for (const formats::CsvRow& row : table.rows) {
    if (cell(row, "quantity") != "rotation") continue;
    const double time = formats::csv_real(table, row, formats::csv_column(table, "time"));
    const int steps = static_cast<int>(std::lround(kSteps * time / kEnd));
    EXPECT_EQ(cell(row, "value"), fmt::format("{:.10g}", -turned(kFalling, time, steps))) << "at " << time;
    ++rotations;
  }
  EXPECT_EQ(rotations, 4);
}

TEST(TopplingColumn, half_the_steps_change_no_printed_digit) {
  EXPECT_NEAR(turned(kFalling, kEnd, kSteps), turned(kFalling, kEnd, kSteps / 2), 1e-13);
}

// The potential energy lost is the energy of rotation gained: a result of the integration that does not depend on its
// rule.
TEST(TopplingColumn, energy_is_kept) {
  const double square = kFalling.width * kFalling.width + kFalling.height * kFalling.height;
  const double first = kSlope - std::atan(kFalling.width / kFalling.height);
  Motion motion{first, 0};
  for (int i = 0; i < kSteps; ++i) motion = kFalling.next(motion, kEnd / kSteps);
  const double lost = kGravity * std::sqrt(square) / 2 * (std::cos(first) - std::cos(motion.theta));
  EXPECT_NEAR(square / 3 * motion.rate * motion.rate / 2 / lost, 1, 1e-12);
}

}  // namespace keyblock::toppling_column_test
