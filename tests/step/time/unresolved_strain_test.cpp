// Rows of stiff blocks that meet at random in steps far longer than their slowest vibration: their energy falls.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/unresolved_strain.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock {
namespace {

std::string box(Point low, Point high, int material) {
  return fmt::format(R"({{"material": {}, "outer": [[{}, {}, 1], [{}, {}, 1], [{}, {}, 1], [{}, {}, 1]]}})", material,
                     low.x, low.y, high.x, low.y, high.x, high.y, low.x, high.y);
}

// `count` blocks of E 40 GPa, in a corner without weight, a micrometre apart, each with a velocity of up to 1 m/s and
// 0.5 rad/s.
std::string row_that_meets_at_random(int count, Point size, double step, unsigned seed) {
  const std::string rock = R"("density": 2500, "unit_weight": 0, "youngs_modulus": 4e10, "poissons_ratio": 0.3)";
  std::string blocks = box({-2, -1}, {size.x * count + 20, 0}, 1) + ", " + box({-2, 0}, {0, size.y}, 1);
  std::string materials = "{" + rock + "}";
  std::minstd_rand dice(seed);
  const auto of_one = [&] { return 2.0 * (dice() - dice.min()) / (dice.max() - dice.min()) - 1; };
  for (int i = 0; i < count; ++i) {
    const double x = of_one(), y = of_one(), turn = of_one() / 2;
    materials += fmt::format(R"(, {{{}, "initial_velocity": [{}, {}, {}]}})", rock, x, y, turn);
    const Point at{size.x * i + 1e-6 * (2 * i + 2 + of_one()), 1e-6 * (2 + of_one())};
    blocks += ", " + box(at, at + size, i + 2);
  }
  return fmt::format(R"({{"keyblock": 1, "blocks": {{"blocks": [{}], "fixed_points": [[-1, -0.8, 1], [{}, -0.2, 1],
    [-1.6, {}, 2], [-0.4, {}, 2]]}}, "analysis": {{"velocity_carry_over": 1, "step_count": 60, "time_step": {},
    "allowed_displacement_ratio": 1, "block_materials": [{}], "joint_materials": [{{"friction_angle_deg": 0}}]}},
    "run": {{"set": {{"gravity": 0}}}}}})",
                     blocks, size.x * count, 0.2 * size.y, 0.8 * size.y, step, materials);
}

// A run whose energy came from nothing ends with exit code 1.
void expect_no_energy_from_nothing(int count, Point size, double step) {
  const std::string folder = support::fresh_folder("unresolved");
  for (unsigned seed = 1; seed <= 5; ++seed) {
    support::write_text(folder + "/row.json", row_that_meets_at_random(count, size, step, seed));
    const support::ProgramRun run =
        support::run_keyblock({"run", folder + "/row.json", "-o", folder + "/out", "--force", "--no-pictures"});
    EXPECT_EQ(run.exit_code, 0) << "seed " << seed << ": " << run.messages;
  }
}

// The slowest strain mode has 25 periods a step. Strain rates left by impacts became strain: energies grew a
// hundredfold in each step, up to the first crushed block.
TEST(UnresolvedStrain, rows_of_stiff_blocks_that_meet_at_random_do_not_explode) {
  expect_no_energy_from_nothing(20, {2, 1}, 0.01);
}

// A whole step leaves springs compressed by 1e-4 m more than by their force. The first part of the next one, which ends
// 5 µs after an impact, pushed them back with up to 1e10 N.
TEST(UnresolvedStrain, parts_of_a_step_do_not_throw_blocks_that_came_to_rest) {
  expect_no_energy_from_nothing(16, {0.5, 2}, 0.005);
}

Body unit_body(double frequency) {
  Body body;
  body.mass = UnknownBlock::Identity(6, 6);
  body.mass(2, 5) = body.mass(5, 2) = 0.5;  // shear turns a block that is not square
  body.stiffness = Body::Stiffness::Identity(3, 3);
  body.slowest_frequency = frequency;
  return body;
}

TEST(UnresolvedStrain, rates_end_if_two_periods_are_shorter_than_the_step_and_momenta_stay) {
  Bodies bodies;
  bodies.push_back(unit_body(13));
  bodies.push_back(unit_body(12));
  UnknownsTable v;
  for (int i = 0; i < 2; ++i) v.push_back(Unknowns::LinSpaced(6, 1, 6));
  const Unknowns momentum = bodies[ElementIndex{0}].mass * v[ElementIndex{0}];
  stop_unresolved(bodies, 1, v);
  EXPECT_EQ(v[ElementIndex{0}].tail(3), Eigen::Vector3d::Zero());
  EXPECT_NEAR((bodies[ElementIndex{0}].mass * v[ElementIndex{0}] - momentum).head(3).norm(), 0, 1e-14);
  EXPECT_EQ(v[ElementIndex{1}], Unknowns(Unknowns::LinSpaced(6, 1, 6)));
}

}  // namespace
}  // namespace keyblock
