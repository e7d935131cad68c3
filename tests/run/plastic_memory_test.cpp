// Elastoplastic rock that becomes another material in a stage: the part of its plastic strain that it keeps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "formats/text/csv.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::plastic_memory_test {
namespace {

using support::fresh_folder;
using support::read_text;
using support::run_keyblock;
using support::write_text;

constexpr double kStress = 50, kE = 1e5, kNu = 0.3;

/// A block of 1 by 1 that yields under one of weight 45, and becomes in a second stage elastic rock of `modulus`. Its
/// measured points 1 and 2 are its centre and the middle of its top.
std::string squeezed(double modulus, const std::string& joint, const std::string& covers) {
  return R"({"keyblock": 1, "blocks": {"blocks": [
    {"outer": [[-2, -1, 1], [3, -1, 1], [3, 0, 1], [-2, 0, 1]], "material": 1},
    {"outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], "material": 2},
    {"outer": [[0, 1, 1], [1, 1, 1], [1, 2, 1], [0, 2, 1]], "material": 3}],
    "fixed_points": [[-2, -1, 1], [3, -1, 1], [-2, 0, 1], [3, 0, 1]],
    "measured_points": [[0.5, 0.5, 2], [0.5, 1, 2]]}, )" +
         covers + R"("analysis": {"step_count": 1, "time_step": 1, "velocity_carry_over": 0, "gravity": 10,
    "plane_strain": true, "allowed_displacement_ratio": 0.05, "joint_materials": [)" +
         joint + R"(], "block_materials": [
    {"density": 1, "unit_weight": 10, "youngs_modulus": 1e7, "poissons_ratio": 0.3},
    {"density": 1, "unit_weight": 10, "youngs_modulus": 1e5, "poissons_ratio": 0.3, "strength": {
      "surface": "tresca", "cohesion": 20, "after": {"plastic_strain": 0.02, "cohesion": 60}}},
    {"density": 4.5, "unit_weight": 45, "youngs_modulus": 1e7, "poissons_ratio": 0.3},
    {"density": 1, "unit_weight": 10, "youngs_modulus": )" +
         std::to_string(modulus) + R"(, "poissons_ratio": 0.3}]},
    "stages": [{"name": "load", "steps": 20, "equilibrium": 1e-4},
      {"name": "other rock", "steps": 20, "equilibrium": 1e-4, "block_materials": [
        {"outline": [[-0.1, -0.1], [1.1, -0.1], [1.1, 1.05], [-0.1, 1.05]], "block_material": 4}]}]})";
}

/// points.csv of a run: the points at the end of the first stage, then at the end of the second.
formats::CsvTable points_of(const std::string& name, const std::string& text) {
  const std::string folder = fresh_folder("plastic_memory_" + name);
  write_text(folder + "/in.json", text);
  EXPECT_EQ(run_keyblock({"run", folder + "/in.json", "-o", folder + "/out"}).exit_code, 0);
  const std::string file = folder + "/out/points.csv";
  return formats::read_csv({file, read_text(file)});
}

double at(const formats::CsvTable& points, std::size_t rows_from_end, const std::string& heading) {
  for (std::size_t i = 0; i < points.header.size(); ++i)
    if (points.header[i] == heading)
      return formats::csv_real(points, points.rows[points.rows.size() - rows_from_end], i);
  ADD_FAILURE() << heading;
  return 0;
}

}  // namespace

// Uniaxial plane strain: the elastic part of the strain is (1 - ν²) σ/E. A block of twice the modulus gives half of it
// back, and keeps the rest, which is plastic.
TEST(PlasticMemory, a_yielded_block_that_becomes_elastic_rock_gives_back_elastic_strain_alone) {
  const formats::CsvTable points = points_of("block", squeezed(2 * kE, R"({"friction_angle_deg": 0})", ""));
  const double elastic = (1 - kNu * kNu) * kStress / kE;
  const double before = at(points, 3, "dy [L]"), after = at(points, 1, "dy [L]");
  EXPECT_LT(before, -5 * elastic);
  EXPECT_NEAR(after - before, elastic / 2, 1e-6 * elastic);
  const double plastic = at(points, 3, "equivalent_plastic_strain");
  EXPECT_GT(plastic, 0);
  EXPECT_EQ(at(points, 1, "equivalent_plastic_strain"), plastic);
  EXPECT_EQ(at(points, 1, "plastic_strain_yy"), at(points, 3, "plastic_strain_yy"));
  EXPECT_EQ(at(points, 1, "yield_state"), 0);
  EXPECT_EQ(at(points, 1, "has_yielded"), 1);
}

// Elastic rock of the same modulus carries the same stress at the same strain: nothing moves.
TEST(PlasticMemory, a_yielded_body_on_covers_that_becomes_elastic_rock_stays_where_it_is) {
  const formats::CsvTable points = points_of(
      "covers", squeezed(kE, R"({"friction_angle_deg": 30, "cohesion": 1e4, "tensile_strength": 1e4})",
                         R"("covers": {"mesh": {"kind": "unstructured", "side": 0.4, "materials": [[2], [4]]}}, )"));
  for (const std::size_t point : {1U, 2U}) {
    const double before = at(points, point + 2, "dy [L]"), after = at(points, point, "dy [L]");
    EXPECT_LT(before, 0);
    EXPECT_NEAR(after, before, 1e-6 * std::abs(before));
    EXPECT_GT(at(points, point + 2, "equivalent_plastic_strain"), 0);
    EXPECT_NEAR(at(points, point, "equivalent_plastic_strain"), at(points, point + 2, "equivalent_plastic_strain"),
                1e-6);
  }
}

}  // namespace keyblock::plastic_memory_test
