// Elastoplastic rock beyond its limit load along the path of equilibria, also where the load falls and the driven
// displacement reverses, beside closed forms of a uniform bar.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::path_of_equilibria_test {
namespace {

using support::fresh_folder;
using support::read_text;
using support::run_keyblock;
using support::write_text;

constexpr double kE = 1000, kYield = 10, kHardening = 12;

/// Nominal stress of a bar with free sides at a stretch, per area before any load: T/λ with T = E ln λ up to the yield
/// stress, then rising by H per plastic strain. It is largest where dT/d(ln λ) = T (Considère 1885).
double nominal(double stretch) {
  const double strain = std::log(stretch);
  const double hardened = (kE * kHardening * strain + kE * kYield) / (kE + kHardening);
  return std::min(kE * strain, hardened) / stretch;
}

double greatest_nominal() {
  const double slope = kE * kHardening / (kE + kHardening), first = kE * kYield / (kE + kHardening);
  return slope * std::exp(first / slope - 1);
}

/// A unit square under plane stress, smooth on its left; `more`: of its covers. Points at the middle of the lower and
/// the upper edge.
std::string bar(const std::string& held, const std::string& more, int steps) {
  return R"({"keyblock": 1, "blocks": {"blocks": [{"outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]}],
    "measured_points": [[0.5, 0, 1], [0.5, 1, 1]]}, "covers": {"mesh": {"placement": "aligned", "side": 2},
    "displacements": [{"along": [[0, 1], [0, 0]], "held": "x"}, )" +
         held + "]" + more + R"(}, "analysis": {"step_count": )" + std::to_string(steps) +
         R"(, "time_step": 1, "allowed_displacement_ratio": 0.1, "plane_strain": false,
    "velocity_carry_over": 0, "joint_materials": [{}], "block_materials": [{"density": 1, "unit_weight": 0,
    "youngs_modulus": 1000, "poissons_ratio": 0.25, "strength": {"surface": "von_mises", "yield_stress": 10,
    "after": {"plastic_strain": 100, "yield_stress": 1210}}}]}, "run": {"set": {"load_control": "arc_length")";
}

struct Path {
  int exit_code = 0;
  std::string messages;
  std::string folder;
  std::vector<double> share, low, high;  ///< of the loads; displacement of both edges
};

Path followed(const std::string& name, const std::string& text, const std::vector<std::string>& more = {}) {
  const std::string folder = fresh_folder("path_" + name);
  write_text(folder + "/in.json", text);
  std::vector<std::string> arguments = {"run", folder + "/in.json", "-o", folder + "/out"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto run = run_keyblock(arguments);
  Path path{run.exit_code, run.messages, folder, {}, {}, {}};
  if (run.exit_code != 0) return path;
  const formats::CsvTable table = formats::read_csv({"history.csv", read_text(folder + "/out/history.csv")});
  const auto column = [&](const char* heading) {
    std::vector<double> values;
    for (const formats::CsvRow& row : table.rows)
      values.push_back(formats::csv_real(table, row, formats::csv_column(table, heading)));
    return values;
  };
  path.share = column("load_share");
  path.low = column("dy1 [L]");
  path.high = column("dy2 [L]");
  return path;
}

const std::string kHeldBelow = R"({"along": [[0, 0], [1, 0]], "held": "y"})";

}  // namespace

// Pulled by a load of 12, of which it carries 10.0: equal increments end there, the path continues.
TEST(PathOfEquilibria, the_load_of_a_bar_falls_beyond_its_greatest) {
  const std::string more = R"(, "tractions": [{"along": [[0, 1], [1, 1]], "y": 12}])";
  const Path path = followed("bar", bar(kHeldBelow, more, 120) + R"(, "path_step": "60"}}})");
  ASSERT_EQ(path.exit_code, 0) << path.messages;
  double most = 0;
  for (std::size_t i = 1; i < path.share.size(); ++i) {
    const double expected = nominal(1 + path.high[i] - path.low[i]);
    ASSERT_NEAR(12 * path.share[i], expected, 1e-6 * greatest_nominal()) << i;
    most = std::max(most, 12 * path.share[i]);
  }
  EXPECT_NEAR(most, greatest_nominal(), 1e-4 * greatest_nominal());
  EXPECT_LT(12 * path.share.back(), 0.95 * greatest_nominal());
  EXPECT_GT(path.high.back(), 0.4);
  const Path shares = followed("shares", bar(kHeldBelow, more, 120) + R"(}}})", {"--set", "load_control=share"});
  EXPECT_EQ(shares.exit_code, 4) << shares.messages;
}

// Its upper edge is pulled away through two springs of 1/2: the displacement of the edge, λ - 1 + P/K, reverses where
// the load falls faster than K.
TEST(PathOfEquilibria, what_drives_a_bar_on_soft_springs_turns_back) {
  const std::string driven = R"({"along": [[0, 1], [1, 1]], "held": "y", "y": 30})";
  const std::string springs = R"(, "springs": [[0, 0, 0, 1, 0.5], [1, 0, 0, 1, 0.5]])";
  const Path path = followed("springs", bar(driven, springs, 130) + R"(, "path_step": "0.43"}}})");
  ASSERT_EQ(path.exit_code, 0) << path.messages;
  double farthest = 0, most = 0;
  for (std::size_t i = 1; i < path.share.size(); ++i) {
    const double stretch = 1 + path.high[i] - path.low[i];
    ASSERT_NEAR(path.low[i], nominal(stretch), 1e-6 * greatest_nominal()) << i;
    // The driven edge gives way a little.
    ASSERT_NEAR(30 * path.share[i], stretch - 1 + nominal(stretch), 1e-5) << i;
    farthest = std::max(farthest, path.high[i]);
    most = std::max(most, stretch);
  }
  EXPECT_LT(path.high.back(), farthest - 0.1);
  EXPECT_GT(most, 2);
}

TEST(PathOfEquilibria, full_loads_end_the_path) {
  const std::string more = R"(, "tractions": [{"along": [[0, 1], [1, 1]], "y": 5}])";
  const Path path = followed("elastic", bar(kHeldBelow, more, 10) + R"(, "path_step": "2"}}})");
  ASSERT_EQ(path.exit_code, 0) << path.messages;
  EXPECT_EQ(path.share.back(), 1);
  EXPECT_LE(path.share.size(), 7U);  // the initial state and as many as half of the steps
  EXPECT_NEAR(nominal(1 + path.high.back() - path.low.back()), 5, 1e-6);
}

TEST(PathOfEquilibria, a_path_leads_through_one_scene) {
  const std::string more = R"(, "excavations": [{"step": 3, "outline": [[0.4, 0.4], [0.6, 0.4], [0.6, 0.6]]}])";
  const Path path = followed("dug", bar(kHeldBelow, more, 10) + R"(}}})");
  EXPECT_EQ(path.exit_code, 3);
  EXPECT_NE(path.messages.find("expected a case without stages"), std::string::npos) << path.messages;
}

}  // namespace keyblock::path_of_equilibria_test
