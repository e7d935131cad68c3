// A drawn slope with crossing joints, by steps in time and by strength reduction, against a block on a plane.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::drawn_slope_test {
namespace {

using support::fresh_folder;
using support::ProgramRun;
using support::run_keyblock;
using support::write_text;
using Json = nlohmann::json;

constexpr double kDip = 33, kFriction = 25;

double rad(double degrees) {
  return degrees * std::numbers::pi / 180;
}
double tangent(double degrees) {
  return std::tan(rad(degrees));
}

/// Bedding that comes out in the face, with steep joints across it: the rock above the lowest bed slides on it as a
/// whole. Corners of four blocks meet at each crossing.
std::string slope(const std::string& name, const std::string& modulus, int steps) {
  std::string entities = "0\nPOLYLINE\n8\nBOUNDARY\n66\n1\n70\n1\n";
  for (const auto& [x, y] : {std::pair{0., 0.}, {30., 0.}, {30., 15.}, {14., 15.}, {6., 4.}, {0., 4.}})
    entities += fmt::format("0\nVERTEX\n8\nBOUNDARY\n10\n{}\n20\n{}\n", x, y);
  entities += "0\nSEQEND\n";
  const auto add = [&](const char* layer, double x, double y, double run, double rise) {
    entities += fmt::format("0\nLINE\n8\n{}\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", layer, x, y, x + run, y + rise);
  };
  for (int i = 0; i < 5; ++i) add("JOINT_1", 5 + 2.5 * i, 4.8 + 0.5 * i, 33, 33 * tangent(kDip));
  for (int i = 0; i < 4; ++i) add("JOINT_2", 15.53 + 5 * i, -5, -24 * tangent(10), 24);
  add("FIXED", 0, 0.01, 30, 0);
  add("FIXED", 29.99, 0, 0, 15);
  entities += "0\nPOINT\n8\nMEASURED\n10\n15.5\n20\n14.5\n";
  const std::string folder = fresh_folder(name);
  const std::string header = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n";
  write_text(folder + "/slope.dxf", header + "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n");
  write_text(folder + "/slope.json", fmt::format(R"({{"keyblock": 2, "drawing": "slope.dxf",
    "units": {{"length": "m", "force": "kN", "time": "s"}},
    "analysis": {{"step_count": {}, "time_step": "5 ms",
      "block_materials": [{{"density": "2600 kg/m3", "youngs_modulus": "{}", "poissons_ratio": 0.22}}],
      "joint_materials": [{{"friction_angle_deg": {}}}, {{"friction_angle_deg": 35}}]}}}})",
                                                 steps, modulus, kFriction));
  return folder;
}

// The rock settles under its weight by micrometres to millimetres, more where it is deeper. Each crossing is a step in
// the bed, on which a corner must not catch.
TEST(DrawnSlope, rock_on_a_bed_steeper_than_its_friction_slides_whatever_it_sank_by) {
  const double time = 0.5;
  const double theory = 9.81 * (std::sin(rad(kDip)) - std::cos(rad(kDip)) * tangent(kFriction)) * time * time / 2;
  for (const char* modulus : {"20 GPa", "1 GPa"}) {
    const std::string folder = slope("drawn_slope", modulus, 100);
    const ProgramRun run = run_keyblock({"run", folder + "/slope.json", "-o", folder + "/out"});
    ASSERT_EQ(run.exit_code, 0) << run.messages;
    const formats::CsvTable history = formats::read_csv(formats::load(folder + "/out/history.csv"));
    const auto last = [&](const char* column) {
      return formats::csv_real(history, history.rows.back(), formats::csv_column(history, column));
    };
    EXPECT_NEAR(std::hypot(last("dx1"), last("dy1")), theory, 2e-3 * theory) << modulus;
  }
}

// An equilibrium must not depend on a caught corner, nor may its search go on for ever if one corner can slide past
// another.
TEST(DrawnSlope, strength_reduction_finds_the_factor_of_a_block_on_a_plane) {
  const std::string folder = slope("drawn_slope_fos", "20 GPa", 10);
  const ProgramRun run = run_keyblock({"fos", folder + "/slope.json", "--json"});
  ASSERT_EQ(run.exit_code, 1) << "it is not safe: " << run.messages;
  const Json found = Json::parse(run.output);
  EXPECT_NEAR(found["factor_of_safety"].get<double>(), tangent(kFriction) / tangent(kDip), 0.01);
}

}  // namespace
}  // namespace keyblock::drawn_slope_test
