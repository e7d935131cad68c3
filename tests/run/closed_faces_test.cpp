// Faces of cracks in frictional contact beside near-tip functions: K of a closed flaw compared with theory, pressure
// without overlap, none if a crack opens.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "fracture/tip_report.hpp"
#include "run/checkpoint.hpp"
#include "run/growth/solution_of.hpp"
#include "run/prepare.hpp"
#include "run/steppers.hpp"

namespace keyblock::closed_faces_test {
namespace {

const double kRoot = std::sqrt(std::numbers::pi);  // √(π c)
constexpr double kAsked = 0.005;                   // of s √(π c)
constexpr double kPerModulus = 0.91e-5;            // (1 - ν²)/E

/// fra-19: compression 1 along y on a plate 40 by 40 with a flaw of half length 1 at 45° in its middle, E 1e5, ν 0.3,
/// plane strain. Sides of 0.1 and less at the tips, which have near-tip functions.
Problem flawed_plate(double friction) {
  Problem problem;
  Blocks blocks;
  BlockPolygon& plate = blocks.blocks.emplace_back();
  for (const Point corner : {Point{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}) plate.outer.push_back({corner, 0});
  problem.geometry = blocks;
  Analysis& analysis = problem.analysis.emplace();
  analysis.step_count = 1;
  analysis.time_step = 1;
  analysis.allowed_displacement_ratio = 0.1;
  analysis.plane_strain = true;
  BlockMaterial& rock = analysis.block_materials.emplace_back();
  rock.density = 1;
  rock.youngs_modulus = 1e5;
  rock.poissons_ratio = 0.3;
  analysis.joint_materials.emplace_back().friction_angle_deg = std::atan(friction) * 180 / std::numbers::pi;
  CoverPlan& covers = problem.covers.emplace();
  covers.mesh.side = 4;
  covers.mesh.angle_deg = 10;
  covers.mesh.through_x = 0.0137;
  covers.mesh.through_y = 0.0071;
  covers.mesh.tip_side = 0.1;
  covers.mesh.tip_functions.kind = TipFunctions::williams;
  const double c = std::sqrt(0.5);
  covers.cracks.emplace_back().along = {{-c, -c}, {c, c}};
  covers.tractions = {{{{-20, 20}, {20, 20}}, {}, {}, {"1", {}}, {}}, {{{-20, -20}, {20, -20}}, {}, {}, {"1", {}}, {}}};
  covers.springs = {{{20, -20}, {1, 0}, 1e5, {}}, {{20, -20}, {0, 1}, 1e5, {}}, {{20, 20}, {1, 0}, 1e5, {}}};
  return problem;
}

/// The same in tension, and without contact.
Problem pulled(Problem problem) {
  for (TractionPlan& part : problem.covers->tractions) part.pressure = {"-1", {}};
  return problem;
}
Problem ignoring(Problem problem) {
  problem.covers->contact = CoverContact::ignored;
  return problem;
}

std::unique_ptr<Stepper> solved(const Problem& problem) {
  std::unique_ptr<Stepper> stepper = stepper_for(prepare(problem, "standard", {}).scene);
  const auto step = stepper->advance();
  if (const auto* failure = std::get_if<StepFailure>(&step)) ADD_FAILURE() << failure->reason;
  return stepper;
}

TipFactors factors_of(const Stepper& stepper, std::size_t tip) {
  const CoverSolution solution = *solution_of(stepper);
  return *tip_report(solution, solution.continuum.manifold.tips[tip]).factors;
}

/// Sums over the points of contact.
struct FaceSums {
  double pressure = 0, shear = 0, slip = 0, overlap = 0;
  int points = 0, pressed = 0;
};

FaceSums sums_of(const ContactFrames& contacts) {
  FaceSums sums;
  for (const ContactFrame& contact : contacts) {
    ++sums.points;
    if (contact.condition != ContactCondition::open) ++sums.pressed;
    sums.pressure += contact.normal_force;
    sums.shear += contact.shear_force;
    sums.slip += std::abs(contact.slip);
    sums.overlap += std::max(0.0, -contact.gap);
    EXPECT_GE(contact.normal_force, 0);
  }
  return sums;
}

}  // namespace

// K_II = -(τ - μ σn) √(π c), τ and σn half of the compression (Horii & Nemat-Nasser 1985), and the J of it. The faces,
// 2 long, carry σn and μ of it.
TEST(ClosedFaces, slip_as_far_as_friction_lets_them) {
  for (const double friction : {0.0, 0.3, 0.6}) {
    const std::unique_ptr<Stepper> stepper = solved(flawed_plate(friction));
    for (const std::size_t tip : {0, 1}) {
      const TipFactors found = factors_of(*stepper, tip);
      const double exact = -0.5 * (1 - friction) * kRoot;
      EXPECT_TRUE(found.is_closed) << friction;
      EXPECT_EQ(found.k.mode_1, 0);
      EXPECT_NEAR(found.k.mode_2, exact, kAsked * kRoot) << friction;
      EXPECT_NEAR(found.j, exact * exact * kPerModulus, 0.03 * 0.25 * kRoot * kRoot * kPerModulus) << friction;
    }
    const FaceSums sums = sums_of(stepper->contacts());
    EXPECT_GT(sums.pressed, 0.9 * sums.points) << friction;
    EXPECT_NEAR(sums.pressure, 2 * 0.5, 0.01) << friction;
    EXPECT_NEAR(std::abs(sums.shear), friction * sums.pressure, 1e-6) << friction;
    EXPECT_LT(sums.overlap, 1e-3 * sums.slip) << friction;
  }
}

// For any sides at the tips and any mesh, along the flaw too: contact in the pieces at the tips keeps the near-tip
// functions from passing the faces through each other.
TEST(ClosedFaces, slip_as_far_on_any_mesh) {
  struct Mesh {
    double tip_side;
    double angle;
    Point through;
  };
  for (const Mesh& mesh : {Mesh{0.25, 10, {0.0137, 0.0071}}, Mesh{0.1, 23, {-0.4, 0.9}}, Mesh{0.1, 45, {0, 0}}}) {
    Problem problem = flawed_plate(0.3);
    problem.covers->mesh.tip_side = mesh.tip_side;
    problem.covers->mesh.angle_deg = mesh.angle;
    problem.covers->mesh.through_x = mesh.through.x;
    problem.covers->mesh.through_y = mesh.through.y;
    const std::unique_ptr<Stepper> stepper = solved(problem);
    for (const std::size_t tip : {0, 1}) {
      const TipFactors found = factors_of(*stepper, tip);
      EXPECT_TRUE(found.is_closed) << mesh.angle;
      EXPECT_NEAR(found.k.mode_2, -0.5 * 0.7 * kRoot, kAsked * kRoot) << mesh.angle;
    }
  }
}

// Friction beyond 1 holds the faces at 45°: K is zero.
TEST(ClosedFaces, stick_where_friction_is_enough) {
  const std::unique_ptr<Stepper> stepper = solved(flawed_plate(1.2));
  const TipFactors found = factors_of(*stepper, 0);
  EXPECT_TRUE(found.is_closed);
  EXPECT_NEAR(found.k.mode_2, 0, kAsked * kRoot);
  const std::unique_ptr<Stepper> free = solved(ignoring(flawed_plate(1.2)));
  EXPECT_NEAR(factors_of(*free, 0).k.mode_1, -0.5 * kRoot, 0.01) << "faces that pass each other";
}

// Compression within the plate, in equilibrium without loads on its edges, closes a flaw as compression on the edges
// does; both together close it twice as hard.
TEST(ClosedFaces, feel_the_initial_stress_of_the_rock) {
  Problem problem = flawed_plate(0.3);
  problem.analysis->block_materials.front().initial_stress.yy = -1;
  EXPECT_NEAR(factors_of(*solved(problem), 0).k.mode_2, -0.5 * 0.7 * kRoot, kAsked * kRoot);
  problem.covers->tractions.clear();
  problem.covers->displacements = {{{{-20, -20}, {20, -20}}, Held::both, {}, {}, {}, {}},
                                   {{{-20, 20}, {20, 20}}, Held::both, {}, {}, {}, {}}};
  EXPECT_NEAR(factors_of(*solved(problem), 0).k.mode_2, -0.5 * 0.7 * kRoot, kAsked * kRoot);
}

TEST(ClosedFaces, of_a_crack_that_opens_bear_nothing) {
  const std::unique_ptr<Stepper> felt = solved(pulled(flawed_plate(0.3)));
  const std::unique_ptr<Stepper> ignored = solved(ignoring(pulled(flawed_plate(0.3))));
  const FaceSums sums = sums_of(felt->contacts());
  EXPECT_GT(sums.points, 50);
  EXPECT_EQ(sums.pressed, 0);
  EXPECT_EQ(sums.pressure, 0);
  EXPECT_TRUE(ignored->contacts().empty());
  const TipFactors found = factors_of(*felt, 0), expected = factors_of(*ignored, 0);
  EXPECT_FALSE(found.is_closed);
  EXPECT_DOUBLE_EQ(found.k.mode_1, expected.k.mode_1);
  EXPECT_DOUBLE_EQ(found.k.mode_2, expected.k.mode_2);
  EXPECT_NEAR(found.k.mode_1, 0.5 * kRoot, 0.01);
}

TEST(ClosedFaces, come_back_from_a_checkpoint) {
  const Scene scene = prepare(flawed_plate(0.3), "standard", {}).scene;
  const std::unique_ptr<Stepper> stepper = stepper_for(scene);
  stepper->advance();
  Archive saved;
  stepper->save(saved);
  Archive restoring = archive_of_checkpoint("checkpoint.h5", checkpoint_bytes(saved));
  const std::unique_ptr<Stepper> again = restored_stepper(scene, restoring);
  const ContactFrames before = stepper->contacts(), after = again->contacts();
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].normal_force, after[i].normal_force);
    EXPECT_EQ(before[i].shear_force, after[i].shear_force);
    EXPECT_EQ(before[i].gap, after[i].gap);
    EXPECT_EQ(before[i].condition, after[i].condition);
  }
  EXPECT_EQ(factors_of(*stepper, 1).k.mode_2, factors_of(*again, 1).k.mode_2);
}

}  // namespace keyblock::closed_faces_test
