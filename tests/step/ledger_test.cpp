// The energy balance closes to round-off, and each of its terms has the sign and the amount of theory.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/ledger.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/support/ledger_runs.hpp"
#include "tests/support/ledger_sums.hpp"

namespace keyblock::step_ledger_test {
namespace {

using support::block_above_floor;
using support::block_on_slope;
using support::column_on_slope;
using support::ledger_of;
using support::plain_analysis;
using support::radians;
using support::rectangle;
using support::standard_scene_of;
using support::standard_settings;

constexpr double kGravity = 9.81;
constexpr double kMass = 2500;       // of a square metre of plain_analysis
constexpr double kRoundOff = 1e-11;  // of the largest energy in the run; measured 3e-13 at most

constexpr std::array<BlockBasis, 2> kBases{BlockBasis::rigid, BlockBasis::affine};
constexpr std::array<Enforcement, 2> kEnforcements{Enforcement::lagrange, Enforcement::penalty};

struct Choices : StandardChoices {
  BlockBasis basis = BlockBasis::affine;
};

Scene sliding(double slope_deg, double friction_deg, const Choices& choices) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.penalty_factor = 10;
  analysis.joint_materials[0].friction_angle_deg = friction_deg;
  Settings settings = standard_settings(analysis);
  settings.basis = choices.basis;
  settings.standard = choices;
  return standard_scene_of(block_on_slope(radians(slope_deg)), analysis, settings);
}

Scene toppling(double dt, const Choices& choices) {
  Analysis analysis = plain_analysis(dt, 1);
  analysis.penalty_factor = 10;
  analysis.joint_materials[0].friction_angle_deg = 50;
  Settings settings = standard_settings(analysis);
  settings.basis = choices.basis;
  settings.standard = choices;
  return standard_scene_of(column_on_slope(radians(20), 5), analysis, settings);
}

Scene dropped(double dt, const Choices& choices) {
  const Analysis analysis = plain_analysis(dt, 1);
  Settings settings = standard_settings(analysis);
  settings.basis = choices.basis;
  settings.standard = choices;
  return standard_scene_of(block_above_floor(1), analysis, settings);
}

Choices choices_of(BlockBasis basis, Enforcement enforcement) {
  Choices choices;
  choices.basis = basis;
  choices.enforcement = enforcement;
  return choices;
}

// The two bodies of dda-13 with masses 2500 and 5000 and speeds 2 and −1: all 7500 J are in their approach.
Scene meeting(BlockBasis basis, double restitution) {
  Blocks blocks;
  blocks.blocks = {rectangle({0, 0}, {1, 1}), rectangle({1.0123, 0}, {2.0123, 1})};
  blocks.blocks[1].material = 1;
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.gravity = 0;
  analysis.block_materials.push_back(analysis.block_materials[0]);
  analysis.block_materials[1].density = 2 * kMass;
  analysis.block_materials[0].initial_velocity = {2, 0, 0};
  analysis.block_materials[1].initial_velocity = {-1, 0, 0};
  Settings settings = standard_settings(analysis);
  settings.basis = basis;
  settings.standard.restitution = restitution;
  return standard_scene_of(blocks, analysis, settings);
}

// A free square metre that was pressed in one direction and let go: σ²/(2 E) of strain energy at the start.
constexpr double kPressure = 1e6;
constexpr double kReleased = kPressure * kPressure / (2 * 5e9);
Scene let_go(double force_weight, StrainDamping damping, double velocity_weight = 0.5) {
  Analysis analysis = plain_analysis(1e-5, 1);
  analysis.gravity = 0;
  analysis.block_materials[0].initial_stress = {-kPressure, 0, 0};
  Settings settings = standard_settings(analysis);
  settings.standard.force_weight = force_weight;
  settings.standard.velocity_weight = velocity_weight;
  settings.standard.strain_damping = damping;
  return standard_scene_of({{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, analysis, settings);
}

}  // namespace

TEST(Ledger, closes_to_round_off_for_every_choice_of_basis_contact_start_weights_and_damping) {
  double worst = 0;
  const auto check = [&](const std::string& what, const Scene& scene, double time) {
    const double closure = support::sums_of(ledger_of(scene, time)).energy_closure();
    EXPECT_LE(closure, kRoundOff) << what;
    worst = std::max(worst, closure);
  };
  for (BlockBasis basis : kBases) {
    for (Enforcement enforcement : kEnforcements) {
      for (StartRule start : {StartRule::compatible, StartRule::sudden}) {
        for (const auto& [velocity_weight, force_weight] :
             {std::pair{0.5, 1.0}, std::pair{0.5, 0.5}, std::pair{0.7, 0.6}, std::pair{1.0, 1.0}}) {
          Choices choices = choices_of(basis, enforcement);
          choices.start = start;
          choices.velocity_weight = velocity_weight;
          choices.force_weight = force_weight;
          const std::string what =
              fmt::format("basis {}, enforcement {}, start {}, weights {} {}", static_cast<int>(basis),
                          static_cast<int>(enforcement), static_cast<int>(start), velocity_weight, force_weight);
          check("slide, " + what, sliding(30, 20, choices), 0.2);
          check("hold, " + what, sliding(30, 35, choices), 0.1);
          check("topple, " + what, toppling(5e-3, choices), 1);
          choices.restitution = 0.6;
          check("drop, " + what, dropped(1e-3, choices), 0.8);
        }
      }
    }
  }
  RecordProperty("worst_closure", fmt::format("{:.1e}", worst));
}

TEST(Ledger, closes_for_integrators_that_carry_accelerations) {
  for (BlockBasis basis : kBases) {
    for (const auto& [integrator, beta, gamma] :
         {std::tuple{Integrator::newmark, 0.25, 0.5}, std::tuple{Integrator::newmark, 0.36, 0.7},
          std::tuple{Integrator::newmark, 0.5, 1.0}, std::tuple{Integrator::generalized_alpha, 0.25, 0.5}}) {
      Choices choices = choices_of(basis, Enforcement::lagrange);
      choices.integrator = integrator;
      choices.newmark_beta = beta;
      choices.newmark_gamma = gamma;
      EXPECT_LE(support::sums_of(ledger_of(sliding(30, 20, choices), 0.2)).energy_closure(), kRoundOff) << beta;
      EXPECT_LE(support::sums_of(ledger_of(toppling(5e-3, choices), 1)).energy_closure(), kRoundOff) << beta;
      choices.restitution = 0.6;
      EXPECT_LE(support::sums_of(ledger_of(dropped(1e-3, choices), 0.8)).energy_closure(), kRoundOff) << beta;
    }
  }
}

TEST(Ledger, gravity_released_in_free_fall_is_kinetic_energy) {
  for (BlockBasis basis : kBases) {
    const Ledger ledger = ledger_of(dropped(1e-3, choices_of(basis, Enforcement::lagrange)), 0.4);
    const StoredEnergy& end = ledger.rows.back().stored;
    const double expected = kMass * kGravity * kGravity * 0.16 / 2;  // m (g t)²/2
    EXPECT_NEAR(end.kinetic / expected, 1, 1e-11);
    EXPECT_NEAR(end.gravity / expected, -1, 1e-11);
    EXPECT_NEAR(ledger.rows.back().impulse.linear.y / (-kMass * kGravity * 0.4), 1, 1e-12);
    EXPECT_NEAR(support::sums_of(ledger).linear_momentum_closure(), 0, kRoundOff);
  }
}

TEST(Ledger, friction_takes_its_force_times_the_way) {
  for (BlockBasis basis : kBases) {
    for (Enforcement enforcement : kEnforcements) {
      const Ledger ledger = ledger_of(sliding(30, 20, choices_of(basis, enforcement)), 0.5);
      const double mu = std::tan(radians(20));
      const double normal = kMass * kGravity * std::cos(radians(30));
      const double way = kGravity / 2 * (std::sin(radians(30)) - mu * std::cos(radians(30))) * 0.25;
      EXPECT_NEAR(ledger.rows.back().flow.friction / (mu * normal * way), 1, 1e-9);
      for (std::size_t i = 1; i < ledger.rows.size(); ++i)
        EXPECT_GE(ledger.rows[i].flow.friction, ledger.rows[i - 1].flow.friction);
    }
  }
}

TEST(Ledger, an_impact_takes_what_restitution_leaves_out) {
  for (BlockBasis basis : kBases) {
    for (double e : {0.0, 0.5, 1.0}) {
      const EnergyFlow flow = ledger_of(meeting(basis, e), 0.05).rows.back().flow;
      EXPECT_NEAR(flow.impact, 7500 * (1 - e * e), 1e-8) << e;
      EXPECT_EQ(flow.projection, 0) << "without weight";
    }
  }
}

// The overlap is at most the displacement of one step. The energy that lifts the block to the height of its rebound is
// the surplus of fall and rebound.
TEST(Ledger, a_drop_loses_to_the_impact_and_projection_stays_within_one_step_of_fall) {
  for (double dt : {1e-3, 1e-4}) {
    for (double e : {0.0, 0.6, 1.0}) {
      Choices choices = choices_of(BlockBasis::rigid, Enforcement::lagrange);
      choices.restitution = e;
      const EnergyFlow flow = ledger_of(dropped(dt, choices), 0.5).rows.back().flow;
      const double fall = kMass * kGravity;  // 1 m
      const double step_of_fall = fall * std::sqrt(2 * kGravity) * dt;
      EXPECT_GE(flow.impact, 0);
      EXPECT_GE(flow.projection, 0);
      EXPECT_LE(flow.projection, (1 + e) * step_of_fall);
      EXPECT_NEAR(flow.impact, fall * (1 - e * e), 2 * step_of_fall) << e;
    }
  }
}

// σ²A/(2E) of uniaxial stress. With Shi's weight it goes to the algorithm, else it stays. With damping it goes to
// damping, except the part that strains following the rate lose to the algorithm.
TEST(Ledger, the_strain_energy_of_a_released_block_goes_where_the_choices_send_it) {
  const auto end_of = [](const Scene& scene) {
    const Ledger ledger = ledger_of(scene, 0.02);
    EXPECT_NEAR(ledger.rows.front().stored.strain, kReleased, 1e-12 * kReleased);
    EXPECT_LE(support::sums_of(ledger).energy_closure(), kRoundOff);
    return ledger.rows.back();
  };
  const LedgerRow damped = end_of(let_go(0.5, StrainDamping::critical));
  EXPECT_NEAR(damped.flow.damping + damped.flow.algorithmic, kReleased, 1e-9 * kReleased);
  EXPECT_GT(damped.flow.algorithmic, 0);
  EXPECT_LT(damped.flow.algorithmic, 0.02 * kReleased);
  const LedgerRow shi = end_of(let_go(1, StrainDamping::none));
  EXPECT_EQ(shi.flow.damping, 0);
  EXPECT_GT(shi.flow.algorithmic, 0.1 * kReleased);
  EXPECT_NEAR(shi.flow.algorithmic + shi.stored.total(), kReleased, 1e-9 * kReleased);
  const LedgerRow backward = end_of(let_go(0.5, StrainDamping::none, 1));
  EXPECT_GT(backward.flow.algorithmic, 0.1 * kReleased);
  const LedgerRow kept = end_of(let_go(0.5, StrainDamping::none));
  EXPECT_NEAR(kept.stored.total(), kReleased, 1e-9 * kReleased);
}

TEST(Ledger, damping_and_algorithmic_loss_never_give_back) {
  for (const Scene& scene : {let_go(1, StrainDamping::none), let_go(0.5, StrainDamping::critical),
                             let_go(0.7, StrainDamping::critical, 0.8)}) {
    const Ledger ledger = ledger_of(scene, 0.005);
    for (std::size_t i = 1; i < ledger.rows.size(); ++i) {
      EXPECT_GE(ledger.rows[i].flow.algorithmic, ledger.rows[i - 1].flow.algorithmic);
      EXPECT_GE(ledger.rows[i].flow.damping, ledger.rows[i - 1].flow.damping);
    }
  }
}

// W = F²t²/(2m) of a constant force on a free block.
TEST(Ledger, a_point_load_does_its_force_times_the_way) {
  Blocks blocks{{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}};
  blocks.loading_points = {{{0.5, 0.5}, 0, {}}};
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.gravity = 0;
  analysis.point_loads = {{{0, 1}, {{3000, 4000}, {3000, 4000}}, {}}};
  const Ledger ledger = ledger_of(standard_scene_of(blocks, analysis, standard_settings(analysis)), 0.5);
  const LedgerRow& end = ledger.rows.back();
  EXPECT_NEAR(end.flow.external / (25e6 * 0.25 / (2 * kMass)), 1, 1e-11);
  EXPECT_NEAR(end.impulse.linear.x, 1500, 1e-9);
  EXPECT_LE(support::sums_of(ledger).energy_closure(), kRoundOff);
  EXPECT_LE(support::sums_of(ledger).linear_momentum_closure(), kRoundOff);
  EXPECT_LE(support::sums_of(ledger).angular_momentum_closure(), kRoundOff);
}

TEST(Ledger, the_geometric_term_of_toppling_is_second_order_in_the_step_and_clean_up_only_loses) {
  for (BlockBasis basis : kBases) {
    std::vector<double> made;
    for (double dt : {4e-3, 2e-3, 1e-3}) {
      const EnergyFlow flow = ledger_of(toppling(dt, choices_of(basis, Enforcement::lagrange)), 1).rows.back().flow;
      made.push_back(std::abs(flow.geometric));
      EXPECT_GE(flow.clean_up, 0);
      // Of some 8e4 J that are released, with the strain rates that a step of 4 ms does not resolve.
      EXPECT_LE(flow.clean_up, 2e-3);
    }
    for (std::size_t i = 1; i < made.size(); ++i)
      EXPECT_GE(std::log2(made[i - 1] / made[i]), 1.9) << made[i - 1] << " J, then " << made[i] << " J";
    RecordProperty(basis == BlockBasis::rigid ? "rigid" : "affine",
                   fmt::format("{:.2e} {:.2e} {:.2e} J", made[0], made[1], made[2]));
  }
}

// A spring under a sudden weight W: it overshoots to 2 W unless it breaks before, and then has taken strength²/(2 k).
TEST(Ledger, a_bolt_that_breaks_takes_what_it_held) {
  constexpr double kStiffness = 1e7;
  const double weight = kMass * kGravity;
  for (double share : {1.5, 2.5}) {
    Blocks blocks = block_above_floor(0);
    blocks.blocks[1] = rectangle({0, -8}, {1, -7});  // below the fixed block
    blocks.bolts = {{{{0.5, -0.9}, {0.5, -7.5}}, 0, 1, kStiffness, share * weight, 0}};
    const Analysis analysis = plain_analysis(1e-4, 1);
    Settings settings = standard_settings(analysis);
    settings.basis = BlockBasis::rigid;
    settings.standard.start = StartRule::sudden;
    const Ledger ledger = ledger_of(standard_scene_of(blocks, analysis, settings), 0.1);
    const double held = share * share * weight * weight / (2 * kStiffness);
    EXPECT_LE(support::sums_of(ledger).energy_closure(), kRoundOff);
    EXPECT_NEAR(ledger.rows.back().flow.rupture, share < 2 ? held : 0, 1e-9 * held);
    EXPECT_EQ(ledger.rows.back().stored.contact > 0, share > 2);
  }
}

// A bolt without stiffness is a constant force: h = (P/m − g) t²/2, and work of P on the way.
TEST(Ledger, a_bolt_without_stiffness_pulls_with_its_pretension) {
  const double weight = kMass * kGravity;
  for (StartRule start : {StartRule::sudden, StartRule::compatible}) {
    Blocks blocks = block_above_floor(0);
    blocks.blocks[1] = rectangle({0, -8}, {1, -7});  // below the fixed block
    blocks.bolts = {{{{0.5, -0.9}, {0.5, -7.5}}, 0, 1, 0, 0, 1.5 * weight}};
    const Analysis analysis = plain_analysis(1e-3, 1);
    Settings settings = standard_settings(analysis);
    settings.basis = BlockBasis::rigid;
    settings.standard.start = start;
    const Ledger ledger = ledger_of(standard_scene_of(blocks, analysis, settings), 0.1);
    const double height = kGravity / 2 * 0.01 / 2;
    EXPECT_LE(support::sums_of(ledger).energy_closure(), kRoundOff);
    EXPECT_NEAR(ledger.rows.back().flow.external, 1.5 * weight * height, 1e-9 * weight);
    EXPECT_NEAR(ledger.rows.back().stored.kinetic, 0.5 * weight * height, 1e-9 * weight);
  }
}

// A point driven at a speed pulls its block along: the support does the work.
TEST(Ledger, a_driven_point_does_the_work_of_its_support) {
  Blocks blocks{{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}};
  blocks.fixed_points = {{{0.5, 0.5}, 0, {}}};
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.gravity = 0;
  analysis.fixed_point_motions = {{{0, 1}, {{0, 0}, {2, 0}}, {}}};
  const Ledger ledger = ledger_of(standard_scene_of(blocks, analysis, standard_settings(analysis)), 0.5);
  const LedgerRow& end = ledger.rows.back();
  EXPECT_TRUE(ledger.scope.has_supports);
  EXPECT_NEAR(end.stored.kinetic, kMass * 4 / 2, 1e-8 * kMass);
  EXPECT_NEAR(end.flow.external - end.flow.clean_up, end.stored.kinetic, 1e-8 * kMass);
  EXPECT_LE(support::sums_of(ledger).energy_closure(), kRoundOff);
}

// Springs that stop an impact hold all of it at the turn and give it back: error second order in dt/Tc.
TEST(Ledger, springs_that_stop_an_impact_hold_its_energy_and_give_it_back) {
  const double contact_time = std::numbers::pi * std::sqrt(kMass / (2 * 10 * 5e9));
  const double energy = kMass / 2;  // at 1 m/s
  for (double part : {0.005, 0.02}) {
    Analysis analysis = plain_analysis(part * contact_time, 1);
    analysis.gravity = 0;
    analysis.penalty_factor = 10;
    analysis.block_materials[0].initial_velocity = {0, -1, 0};
    Settings settings = standard_settings(analysis);
    settings.basis = BlockBasis::rigid;
    settings.standard.enforcement = Enforcement::penalty;
    settings.standard.impact = ImpactLaw::springs;
    const Ledger ledger = ledger_of(standard_scene_of(block_above_floor(1.3 * analysis.time_step), analysis, settings),
                                    1.2 * contact_time);
    double held = 0;
    for (const LedgerRow& row : ledger.rows) held = std::max(held, row.stored.contact);
    const double second_order = 10 * part * part;
    EXPECT_NEAR(held, energy, second_order * energy);
    EXPECT_NEAR(ledger.rows.back().stored.kinetic, energy, second_order * energy);
    EXPECT_NEAR(ledger.rows.back().flow.algorithmic, 0, second_order * energy);
    EXPECT_NEAR(ledger.rows.back().flow.closing, 0, second_order * energy);
    EXPECT_LE(support::sums_of(ledger).energy_closure(), kRoundOff);
  }
}

TEST(Ledger, velocity_that_is_not_carried_over_is_damping) {
  Scene scene = dropped(1e-3, choices_of(BlockBasis::rigid, Enforcement::lagrange));
  scene.settings.velocity_carry_over = 0;
  const Ledger ledger = ledger_of(scene, 0.1);
  const LedgerRow& end = ledger.rows.back();
  EXPECT_GT(end.flow.damping, 0);
  EXPECT_NEAR(end.flow.damping + end.stored.total(), 0, 1e-12 * end.flow.damping);
}

TEST(Ledger, free_bodies_keep_linear_and_angular_momentum_through_a_central_impact) {
  for (BlockBasis basis : kBases) {
    const Ledger ledger = ledger_of(meeting(basis, 0.5), 0.05);
    EXPECT_FALSE(ledger.scope.has_supports);
    EXPECT_LE(support::sums_of(ledger).linear_momentum_closure(), 1e-12);
    EXPECT_LE(support::sums_of(ledger).angular_momentum_closure(), 1e-12);
  }
}

TEST(Ledger, no_books_are_kept_where_the_settings_say_so) {
  Scene scene = dropped(1e-3, choices_of(BlockBasis::rigid, Enforcement::lagrange));
  scene.settings.ledger = Bookkeeping::off;
  EXPECT_EQ(ledger_of(scene, 0.01).rows.back().stored.kinetic, 0);
}

}  // namespace keyblock::step_ledger_test
