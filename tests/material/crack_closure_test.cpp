// Cracks that close: pla-12, the energy compared with its definition, convexity, loops of strain, and strength besides.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/crack_closure.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "material/crack_return.hpp"
#include "material/principal_axes.hpp"
#include "material/rock_point.hpp"
#include "material/strength.hpp"
#include "material/yield_law.hpp"

namespace keyblock::crack_closure_test {
namespace {

// Those of pla-12, in MPa.
constexpr double kOpen = 10e3, kIntact = 30e3, kClosed = 5e-4;

CrackedElasticity rock(double poissons_ratio = 0.25) {
  return {kIntact, poissons_ratio, {kOpen, kClosed}};
}

YieldLaw law_of(const Strength& strength) {
  YieldLaw law{kIntact, 0.25, strength};
  law.closure = CrackClosure{kOpen, kClosed};
  return law;
}

Strength mohr_coulomb(double friction, double dilation, double cohesion, std::optional<double> tension = {}) {
  Strength s;
  s.values = {.cohesion = cohesion, .friction_deg = friction, .dilation_deg = dilation, .tensile_strength = tension};
  return s;
}

std::vector<Strength> surfaces() {
  Strength tresca = mohr_coulomb(0, 0, 20), von_mises, cone = mohr_coulomb(30, 10, 20);
  tresca.surface = YieldSurface::tresca;
  von_mises.surface = YieldSurface::von_mises;
  von_mises.values.yield_stress = 40;
  cone.surface = YieldSurface::drucker_prager;
  Strength softening = mohr_coulomb(30, 10, 20);
  softening.change = StrengthChange{.values = softening.values, .plastic_strain = 0.01};
  softening.change->values.cohesion = 10;
  return {
      mohr_coulomb(30, 30, 2), mohr_coulomb(30, 0, 2), mohr_coulomb(30, 10, 20, 1), tresca, von_mises, cone, softening};
}

/// A strain of a size between 1e-5 and 1e-1, half of them mostly isotropic.
Eigen::Vector4d random_strain(std::mt19937_64& dice) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> even(0, 1);
  const double size = std::pow(10, -5 + 4 * even(dice));
  Eigen::Vector4d strain;
  for (int i = 0; i < 4; ++i) strain(i) = size * normal(dice);
  if (even(dice) < 0.5) strain += size * normal(dice) * Eigen::Vector4d(1, 1, 0, 1);
  return strain;
}

/// ½ (e - w) · D (e - w) + ½ k w · w.
double energy_at(const Eigen::VectorXd& strain, const Eigen::VectorXd& cracks, const Eigen::MatrixXd& modulus) {
  const Eigen::VectorXd intact = strain - cracks;
  const double k = 1 / (1 / kOpen - 1 / kIntact);
  return intact.dot(modulus * intact) / 2 + k * cracks.squaredNorm() / 2;
}

/// Minimum over w, one crack after another until none changes: another method than sets of closed cracks.
double least_energy(const Eigen::VectorXd& strain, const Eigen::MatrixXd& modulus) {
  const double k = 1 / (1 / kOpen - 1 / kIntact), shut = -kClosed * (1 - kOpen / kIntact);
  Eigen::VectorXd w = Eigen::VectorXd::Zero(strain.size());
  for (int round = 0; round < 2000; ++round)
    for (Eigen::Index i = 0; i < w.size(); ++i) {
      const double slope = k * w(i) - modulus.row(i).dot(strain - w);
      w(i) = std::max(w(i) - slope / (k + modulus(i, i)), shut);
    }
  return energy_at(strain, w, modulus);
}

Eigen::MatrixXd principal_modulus(Eigen::Index count) {
  Eigen::MatrixXd c = Eigen::MatrixXd::Constant(count, count, -0.25 / kIntact);
  c.diagonal().setConstant(1 / kIntact);
  return c.inverse();
}

}  // namespace

// Shape of pla-12: E1 to the closure strain, then E2; tension has E1.
TEST(CrackClosure, uniaxial_stress_has_the_bilinear_curve) {
  for (const bool is_plane_stress : {false, true})
    for (const auto& [axial, stress] :
         {std::array{-2e-4, -2.}, {-5e-4, -5.}, {-1e-3, -20.}, {-2e-3, -50.}, {1e-4, 1.}}) {
      const Eigen::Vector4d strain = law_of({}).elastic_strain({0, stress, 0, 0});
      EXPECT_NEAR(strain(1), axial, 1e-18);
      EXPECT_NEAR(strain(0), -0.25 * stress / kIntact, 1e-18);  // cracks have no lateral strain
      const CrackedResponse r = cracked_response(rock(), strain, is_plane_stress);
      EXPECT_LT((r.stress - Eigen::Vector4d(0, stress, 0, 0)).norm(), 1e-12);
      EXPECT_NEAR(r.strain(3), strain(3), 1e-18);
    }
}

TEST(CrackClosure, the_energy_is_the_least_of_its_definition) {
  std::mt19937_64 dice(3);
  for (int i = 0; i < 200; ++i)
    for (const bool is_plane_stress : {false, true}) {
      const Eigen::Vector4d strain = random_strain(dice);
      const PlaneAxes axes(Eigen::Vector4d(strain(0), strain(1), strain(2) / 2, strain(3)));
      const Eigen::Index count = is_plane_stress ? 2 : 3;
      const double least = least_energy(axes.values.head(count), principal_modulus(count));
      EXPECT_NEAR(cracked_response(rock(), strain, is_plane_stress).stored, least, 1e-12 * least);
    }
}

TEST(CrackClosure, stress_is_the_slope_of_the_energy_and_the_tangent_that_of_stress) {
  std::mt19937_64 dice(4);
  for (int i = 0; i < 300; ++i)
    for (const bool is_plane_stress : {false, true}) {
      const Eigen::Vector4d strain = random_strain(dice);
      const double h = 1e-5 * strain.norm();
      const CrackedResponse r = cracked_response(rock(), strain, is_plane_stress);
      Eigen::Vector4d slope = Eigen::Vector4d::Zero();
      Eigen::Matrix4d tangent = Eigen::Matrix4d::Zero();
      bool has_kink = false;
      for (int j = 0; j < (is_plane_stress ? 3 : 4); ++j) {
        const Eigen::Vector4d way = h * Eigen::Vector4d::Unit(j);
        const CrackedResponse forth = cracked_response(rock(), strain + way, is_plane_stress);
        const CrackedResponse back = cracked_response(rock(), strain - way, is_plane_stress);
        has_kink = has_kink || forth.closed != back.closed;
        slope(j) = (forth.stored - back.stored) / (2 * h);
        tangent.col(j) = (forth.stress - back.stress) / (2 * h);
      }
      if (has_kink) continue;
      EXPECT_LT((slope - r.stress).norm(), 1e-8 * r.stress.norm());
      EXPECT_LT((tangent - r.tangent).norm(), 1e-7 * r.tangent.norm());
      EXPECT_LT((r.tangent - r.tangent.transpose()).norm(), 1e-12 * r.tangent.norm());
    }
}

// The softest answer in series has all cracks open under shear, 1/((1 + ν)/E2 + 1/k).
TEST(CrackClosure, stiffness_between_two_strains_is_never_below_that_of_open_cracks) {
  const double softest = 1 / (1.25 / kIntact + 1 / kOpen - 1 / kIntact);
  std::mt19937_64 dice(5);
  double least = kIntact;
  for (int i = 0; i < 10000; ++i) {
    const Eigen::Vector4d a = random_strain(dice),
                          b = i % 2 == 0 ? random_strain(dice) : Eigen::Vector4d(a + random_strain(dice));
    const Eigen::Vector4d strain = b - a;
    const double rise =
        strain.dot(cracked_response(rock(), b, false).stress - cracked_response(rock(), a, false).stress);
    const double square = strain.squaredNorm() - strain(2) * strain(2) / 2;  // of the tensor
    least = std::min(least, rise / square);
  }
  EXPECT_GT(least, softest * (1 - 1e-9));
  EXPECT_LT(least, 1.2 * softest);  // the pairs come near it
}

// Axes rotate, cracks close and open one after another: a loop gives back all energy that it took.
TEST(CrackClosure, a_closed_loop_of_strain_does_no_work) {
  const std::array<Eigen::Vector4d, 6> corners{{{0, 0, 0, 0},
                                                {-2e-3, 1e-3, 0, 0},
                                                {-2e-3, -3e-3, 2e-3, 0},
                                                {1e-3, -3e-3, -2e-3, -1e-3},
                                                {-4e-3, -1e-3, 1e-3, -2e-3},
                                                {0, 0, 0, 0}}};
  for (const bool is_plane_stress : {false, true}) {
    double work = 0, most = 0;
    for (std::size_t leg = 0; leg + 1 < corners.size(); ++leg) {
      constexpr int kParts = 20000;
      const Eigen::Vector4d part = (corners[leg + 1] - corners[leg]) / kParts;
      for (int i = 0; i < kParts; ++i) {
        // Gauss's rule of two points.
        for (const double at : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)})
          work += cracked_response(rock(), corners[leg] + (i + at) * part, is_plane_stress).stress.dot(part) / 2;
        most = std::max(most, std::abs(work));
      }
    }
    EXPECT_LT(std::abs(work), 1e-8 * most);
  }
}

TEST(CrackClosure, what_is_no_closure_is_refused) {
  EXPECT_EQ(why_unusable(CrackClosure{10e3, 5e-4}, 30e3), "");
  EXPECT_NE(why_unusable(CrackClosure{30e3, 5e-4}, 30e3).find("initial_modulus"), std::string::npos);
  EXPECT_NE(why_unusable(CrackClosure{0, 5e-4}, 30e3).find("initial_modulus"), std::string::npos);
  EXPECT_NE(why_unusable(CrackClosure{10e3, 0}, 30e3).find("closure_strain"), std::string::npos);
}

// A stress on the surface, with the crack strain of that stress, and the answer of intact rock to the rest of the
// strain.
TEST(CrackReturn, random_trials_end_on_the_surface_with_the_cracks_of_their_stress) {
  std::mt19937_64 dice(6);
  for (const Strength& strength : surfaces())
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      const YieldLaw law = law_of(strength);
      YieldLaw intact = law;
      intact.closure.reset();
      const SurfaceOfKappa surface{law.strength, strain_of_change(law.strength, 1)};
      const bool is_normal = strength.values.dilation_deg == strength.values.friction_deg && !strength.change;
      int yielded = 0;
      for (int i = 0; i < 2000; ++i) {
        const Eigen::Vector4d strain = random_strain(dice);
        YieldState before;
        before.elastic = 0.7 * strain;
        const Eigen::Vector4d change = strain - before.elastic;
        const Response r = plane == Plane::stress ? respond_plane_stress(law, change.head<3>(), before, 1)
                                                  : respond(law, change, before, 1);
        ASSERT_TRUE(r.stress.allFinite() && r.tangent.allFinite() && r.after.plastic.allFinite());
        ASSERT_TRUE(r.is_found);
        Eigen::Vector3d s = PlaneAxes(r.stress).values;
        std::ranges::sort(s, std::greater<>());
        const double size = std::max(s.cwiseAbs().maxCoeff(), surface_scale(surface, 0));
        ASSERT_LT(excess_of_stress(surface, r.after.kappa, s), 1e-12 * size);
        if (r.after.region == YieldRegion::elastic) continue;
        ++yielded;
        // The state has the stress, by elasticity alone.
        const CrackedResponse again = cracked_response(law.cracked(), r.after.elastic, plane == Plane::stress);
        const double trial = kIntact * strain.norm() + size;
        ASSERT_LT((again.stress - r.stress).norm(), 1e-12 * trial);
        YieldState reached;
        reached.elastic = strain - (r.after.elastic - law.intact_strain(r.stress));
        if (plane == Plane::stress) reached.elastic(3) = before.elastic(3);
        const Response of_intact = plane == Plane::stress
                                       ? respond_plane_stress(intact, Eigen::Vector3d::Zero(), reached, 1)
                                       : respond(intact, Eigen::Vector4d::Zero(), reached, 1);
        ASSERT_LT((of_intact.stress - r.stress).norm(), 1e-12 * trial);
        if (is_normal) {
          ASSERT_GT(r.stress.dot(r.plastic), -1e-12 * trial * strain.norm());
        }
      }
      EXPECT_GT(yielded, 250);
    }
}

// Friction of 80 degrees without dilation in rock of nearly constant volume: of 40,000 random strains the one whose
// search ends off the crack strain of its stress.
TEST(CrackReturn, a_search_that_fails_is_flagged) {
  YieldLaw law{kIntact, 0.49, mohr_coulomb(80, 0, 20)};
  law.closure = CrackClosure{kOpen, kClosed};
  const Eigen::Vector4d strain(0.0092821889401654249, 0.045544447649867259, -0.01550478956488973,
                               -0.055526282996224231);
  EXPECT_FALSE(respond(law, strain, {}, 1).is_found);
  EXPECT_TRUE(respond(law, 0.9 * strain, {}, 1).is_found);
}

TEST(CrackReturn, the_tangent_is_the_derivative) {
  std::mt19937_64 dice(7);
  for (const Strength& strength : surfaces())
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      const YieldLaw law = law_of(strength);
      const auto at = [&](const Eigen::Vector4d& strain) {
        return plane == Plane::stress ? respond_plane_stress(law, strain.head<3>(), {}, 1)
                                      : respond(law, strain, {}, 1);
      };
      int tried = 0, wrong = 0;
      for (int i = 0; i < 200; ++i) {
        const Eigen::Vector4d strain = random_strain(dice);
        const Response r = at(strain);
        if (r.after.region == YieldRegion::elastic) continue;
        const double h = 1e-6 * strain.norm();
        Eigen::Matrix4d tangent = Eigen::Matrix4d::Zero();
        for (int j = 0; j < (plane == Plane::stress ? 3 : 4); ++j) {
          const Eigen::Vector4d way = h * Eigen::Vector4d::Unit(j);
          tangent.col(j) = (at(strain + way).stress - at(strain - way).stress) / (2 * h);
        }
        ++tried;
        wrong += (tangent - r.tangent).norm() > 1e-5 * kIntact ? 1 : 0;
      }
      EXPECT_GT(tried, 50);
      EXPECT_LE(wrong, tried / 20);  // differences across a kink
    }
}

// Discrete gradient: if cracks close on the way, the corrected mean stress does the work of the energy.
TEST(CrackReturn, the_stress_of_a_way_does_the_work_of_its_energy) {
  std::mt19937_64 dice(8);
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const auto law = std::make_shared<const YieldLaw>(yield_law([] {
      BlockMaterial material;
      material.youngs_modulus = kIntact;
      material.poissons_ratio = 0.25;
      material.crack_closure = CrackClosure{kOpen, kClosed};
      return material;
    }()));
    const Eigen::Vector4d stress(-3, -7, 1, plane == Plane::stress ? 0 : -2);
    const RockPoint point{law, plane, 2, law->elastic_strain(stress)};
    EXPECT_LT((point.stress(Eigen::Vector3d::Zero(), {}) - stress).norm(), 1e-12);
    EXPECT_EQ(point.stored(Eigen::Vector3d::Zero(), {}), 0);
    double largest = 0;
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector3d from = random_strain(dice).head<3>() / 10, to = random_strain(dice).head<3>() / 10;
      const Eigen::Vector3d mean = (point.stress(from, {}) + point.stress(to, {})).head<3>() / 2;
      const Eigen::Vector3d lacks = point.missing_stress(from, {}, to, {});
      const double change = point.stored(to, {}) - point.stored(from, {});
      const double size = std::abs(point.stored(to, {})) + std::abs(point.stored(from, {}));
      EXPECT_NEAR(2 * (mean + lacks).dot(to - from), change, 1e-12 * size);
      largest = std::max(largest, lacks.norm() / mean.norm());
    }
    EXPECT_GT(largest, 1e-3);
  }
}

}  // namespace keyblock::crack_closure_test
