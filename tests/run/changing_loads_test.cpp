// Tractions on NMM bodies that change over time, beside theory and beside a block; scenes without a time refuse them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/stepped_case.hpp"

namespace keyblock::changing_loads_test {
namespace {

using support::fault_of;
using support::stepper_of;

constexpr double kDensity = 2000, kLength = 2, kHeight = 1;
constexpr int kSteps = 20;
constexpr double kDt = 0.01;

/// A free body 2 m long and 1 m high; `loads` are the entries of `loads`, `more` further keys of the case.
std::string text_of(const std::string& loads, const std::string& set, const std::string& more) {
  return fmt::format(
      R"({{"keyblock": 2, "blocks": {{"blocks": [{{"outer": [[0, 0, 1], [{0}, 0, 1], [{0}, {1}, 1], [0, {1}, 1]]}}],
      "measured_points": [[1, 0.5, 1]]}},
      "loads": {{{2}}}, {3} "analysis": {{"step_count": {4}, "time_step": {5}, "velocity_carry_over": 1,
      "plane_strain": true, "gravity": 0, "joint_materials": [{{"friction_angle_deg": 30}}],
      "block_materials": [{{"density": {6}, "youngs_modulus": 1e9, "poissons_ratio": 0.25}}]}},
      "run": {{"set": {{{7}}}}}}})",
      kLength, kHeight, loads, more, kSteps, kDt, kDensity, set);
}

constexpr const char* kMesh = R"("covers": {"mesh": {"side": 0.5}},)";

/// Way along x of the point in the middle, after each step.
std::vector<double> ways(const std::string& load, const std::string& more) {
  const std::string pushed = R"("tractions": [{"along": [[0, 1], [0, 0]], )" + load + "}]";
  const auto stepper = stepper_of(text_of(pushed, R"("start": "sudden")", more));
  std::vector<double> way;
  for (int i = 0; i < kSteps; ++i) {
    const auto made = stepper->advance();
    if (const auto* failure = std::get_if<StepFailure>(&made)) ADD_FAILURE() << failure->reason;
    way.push_back(stepper->state().measured_points.at(0).displacement.x);
  }
  return way;
}

// Rounding and waves through the body, 6 ms long, beside ways of 0.2 s.
constexpr double kOfWaves = 0.01;

// The way is p' t³ A / (6 m) under the pressure p' t on the area A.
TEST(ChangingLoads, an_NMM_body_under_a_ramp_of_pressure_goes_the_way_of_theory) {
  constexpr double kRate = 2e4, kMass = kDensity * kLength * kHeight;
  const std::vector<double> by_formula = ways(R"("pressure": "2e4 * t")", kMesh);
  const std::vector<double> by_table = ways(R"("pressure": 4000, "over_time": [[0, 0], [0.2, 1]])", kMesh);
  const double last = kRate * std::pow(kSteps * kDt, 3) * kHeight / (6 * kMass);
  for (std::size_t i = 0; i < by_formula.size(); ++i) {
    EXPECT_NEAR(by_formula[i], last * std::pow((static_cast<double>(i) + 1) / kSteps, 3), kOfWaves * last) << i;
    EXPECT_NEAR(by_formula[i], by_table[i], 1e-9 * last) << i;
  }
}

TEST(ChangingLoads, a_table_of_equal_factors_is_a_constant_traction) {
  const std::vector<double> changing = ways(R"("x": 4000, "over_time": [[0, 1], [1, 1]])", kMesh);
  const std::vector<double> constant = ways(R"("x": 4000)", kMesh);
  for (std::size_t i = 0; i < changing.size(); ++i) EXPECT_NEAR(changing[i], constant[i], 1e-12) << i;
}

// The way is p A / (m w²) (w t - sin w t) under the traction p sin w t.
TEST(ChangingLoads, a_mesh_and_a_block_follow_the_same_sine) {
  const std::string load = R"x("x": "4000 * sin(10 * t)")x";
  const std::vector<double> mesh = ways(load, kMesh);
  const std::vector<double> block = ways(load, "");
  const double last = 4000 / (kDensity * kLength) / 100 * (2 - std::sin(2.0));
  EXPECT_NEAR(block.back(), last, kOfWaves * last);
  for (std::size_t i = 0; i < mesh.size(); ++i) EXPECT_NEAR(mesh[i], block[i], kOfWaves * last) << i;
}

TEST(ChangingLoads, a_scene_that_has_no_time_refuses_them) {
  const std::string held = R"("displacements": [{"along": [[2, 0], [2, 1]], "held": "both"}], )";
  const std::string load = R"("tractions": [{"along": [[0, 1], [0, 0]], "x": "t"}])";
  const std::string statics = text_of(held + load, R"("motion": "static")", kMesh);
  EXPECT_NE(fault_of(statics).find("no time t on NMM bodies in statics without contact"), std::string::npos);
  const std::string moved =
      R"("displacements": [{"along": [[2, 0], [2, 1]], "held": "x", "x": 0.1, "over_time": [[0, 0], [1, 1]]}])";
  EXPECT_NE(fault_of(text_of(moved, R"("start": "sudden")", kMesh)).find("displacements only on blocks"),
            std::string::npos);
  const std::string cracked = R"("covers": {"mesh": {"side": 0.25}, "cracks": [{"along": [[0.7, 0.5], [1.3, 0.5]]}]},)";
  EXPECT_NE(fault_of(text_of(load, R"("start": "sudden")", cracked)).find("on NMM bodies with cracks"),
            std::string::npos);
}

}  // namespace
}  // namespace keyblock::changing_loads_test
