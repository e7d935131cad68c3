// The error of a mesh in the factor of safety of a slope without cohesion, whose factor is known.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/strength/mesh_error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "formats/case.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::study::mesh_error_test {
namespace {

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

/// 5 high, 2:1, of sand with 35 degrees of friction.
StrengthTrials sand_slope(double side) {
  const std::string file = support::fresh_folder("mesh_error") + "/slope.json";
  support::write_text(file, fmt::format(R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[-8, -4, 1], [20, -4, 1],
    [20, 5, 1], [10, 5, 1], [0, 0, 1], [-8, 0, 1]]}}]}}, "covers": {{"mesh": {{"kind": "unstructured",
    "placement": "aligned", "side": {}}}, "displacements": [{{"along": [[-8, -4], [20, -4]]}},
    {{"along": [[20, -4], [20, 5]], "held": "normal"}}, {{"along": [[-8, 0], [-8, -4]], "held": "normal"}}]}},
    "analysis": {{"step_count": 4, "time_step": 1, "allowed_displacement_ratio": 0.1, "plane_strain": true,
    "block_materials": [{{"density": 1.7329255861365953, "unit_weight": 17, "youngs_modulus": 1e5,
    "poissons_ratio": 0.3, "strength": {{"surface": "mohr_coulomb", "cohesion": 0, "friction_deg": 35,
    "dilation_deg": 35}}}}], "joint_materials": [{{}}]}}}})",
                                        side));
  return {configured_under("standard", {}, formats::load_case({file}).problem), Reduced::rock};
}

}  // namespace

// A slope of sand fails along its face at tan φ / tan β, where the mesh is coarsest beside what moves.
TEST(MeshError, of_a_slope_of_sand_is_seen) {
  const StrengthTrials trials = sand_slope(1);
  ASSERT_TRUE(trials.depends_on_mesh());
  SearchOptions options;
  options.within = 0.02;
  options.seeks_knee = false;
  const FactorOfSafety found = factor_of_safety(trials, options);
  ASSERT_EQ(found.end, SearchEnd::bracketed);
  const MeshError error = mesh_error(trials, found, options);
  ASSERT_TRUE(error.coarse) << error.why_none;
  const double exact = tangent(35) / 0.5;
  const double true_error = found.bracket.middle() / exact - 1;
  EXPECT_GT(true_error, 0.03);
  EXPECT_LT(error.least, 1.2 * true_error);
  EXPECT_GT(error.most, 0.8 * true_error);
  EXPECT_LT(error.least, error.share);
  EXPECT_LT(error.share, error.most);
  EXPECT_NE(in_words(error).find("mesh error about +"), std::string::npos) << in_words(error);
}

TEST(MeshError, joints_alone_have_none) {
  const std::string name = KEYBLOCK_SOURCE_DIR "/legacy_cases/strength_reduction/block_on_plane/block_on_plane";
  const Problem problem = formats::load_case({name + ".blk", name + ".ana"}).problem;
  const StrengthTrials trials{configured_under("standard", {}, problem), Reduced::joints};
  EXPECT_FALSE(trials.depends_on_mesh());
}

}  // namespace keyblock::study::mesh_error_test
