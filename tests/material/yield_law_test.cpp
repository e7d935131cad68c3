// Strength of a point: return vectors of the benchmarks, a million random trial stresses, tangents against differences,
// cyclic paths, softening and plane stress.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/yield_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "base/sentences/sentences.hpp"
#include "material/crack_return.hpp"
#include "material/strength.hpp"

namespace keyblock::yield_law_test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Strength mohr_coulomb(double friction, double dilation, double cohesion, std::optional<double> tension = {}) {
  Strength s;
  s.values = {.cohesion = cohesion, .friction_deg = friction, .dilation_deg = dilation, .tensile_strength = tension};
  return s;
}

Strength von_mises(double yield_stress) {
  Strength s;
  s.surface = YieldSurface::von_mises;
  s.values.yield_stress = yield_stress;
  return s;
}

Strength cone(ConeMatching matching, double friction, double dilation, double cohesion,
              std::optional<double> tension = {}) {
  Strength s = mohr_coulomb(friction, dilation, cohesion, tension);
  s.surface = YieldSurface::drucker_prager;
  s.matching = matching;
  return s;
}

YieldLaw law_of(const Strength& strength, double poissons_ratio = 0.25) {
  return {1000, poissons_ratio, strength};
}

Eigen::Matrix3d principal_modulus(double poissons_ratio = 0.25) {
  const Eigen::Matrix4d d = law_of({}, poissons_ratio).modulus();
  Eigen::Matrix3d p = Eigen::Matrix3d::Constant(d(0, 1));
  p.diagonal().setConstant(d(0, 0));
  return p;
}

/// All kinds of surface that a point may have.
std::vector<Strength> all_surfaces() {
  std::vector<Strength> all;
  for (const auto& [phi, psi, c] : {std::array{30., 30., 2.},
                                    {30., 0., 2.},
                                    {30., 10., 2.},
                                    {0., 0., 2.},
                                    {20., 20., 0.},
                                    {30., 0., 0.},
                                    {45., 45., 1e-6},
                                    {50., 5., 1.},
                                    {1e-6, 1e-6, 1.}})
    all.push_back(mohr_coulomb(phi, psi, c));
  for (const double tension : {0.0, 0.5, 3.0, 100.0}) all.push_back(mohr_coulomb(30, 30, 2, tension));
  all.push_back(mohr_coulomb(40, 5, 2, 1.0));
  all.push_back(mohr_coulomb(0, 0, 2, 0.7));
  all.push_back(von_mises(10));
  for (const ConeMatching matching : {ConeMatching::compression, ConeMatching::extension, ConeMatching::plane_strain})
    for (const auto& [psi, tension] : {std::pair<double, std::optional<double>>{30, {}}, {0, {}}, {10, 1.0}, {30, 0.0}})
      all.push_back(cone(matching, 30, psi, 2, tension));
  return all;
}

/// Trial stresses of many sizes, with equal and nearly equal ones, shifted by pressure; largest first.
Eigen::Vector3d random_trial(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uniform_int_distribution<int> kind(0, 5);
  const double size = std::pow(10.0, 3 + 5 * unit(random));
  Eigen::Vector3d t(unit(random), unit(random), unit(random));
  const double near = std::pow(10.0, -10 + 6 * unit(random));
  switch (kind(random)) {
    case 0:
      t(1) = t(0);
      break;
    case 1:
      t(1) = t(0) + near * unit(random);
      break;
    case 2:
      t(1) = t(2) = t(0);
      break;
    case 3:
      t(1) = t(0) + near * unit(random);
      t(2) = t(0) + near * unit(random);
      break;
    default:
      break;
  }
  t = size * (t.array() + 2 * unit(random)).matrix();
  std::sort(t.data(), t.data() + 3, std::greater<>());
  return t;
}

struct Worst {
  double surface = 0, order = 0, work = 0, flow = 0;
};

/// Checks, for an associated law, that its return is the projection in the norm of energy: (σᵗʳ - σ) · D⁻¹ (σ - y) ≥ 0
/// for any y inside.
void check_trial(const Strength& strength, const Eigen::Vector3d& trial, std::mt19937_64& random, Worst& worst) {
  const SurfaceOfKappa surface{strength, kInfinite};
  const Eigen::Matrix3d modulus = principal_modulus();
  const Eigen::Vector3d stress = stress_on_surface(surface, 0, trial, modulus);
  ASSERT_TRUE(stress.allFinite()) << trial.transpose();
  const double size = std::max(stress.cwiseAbs().maxCoeff(), surface_scale(surface, 0));
  const double great = std::max(trial.cwiseAbs().maxCoeff(), size);
  worst.surface = std::max(worst.surface, excess_of_stress(surface, 0, stress) / size);
  worst.order = std::max({worst.order, stress(1) - stress(0), stress(2) - stress(1)});
  const Eigen::Vector3d plastic = modulus.ldlt().solve(trial - stress);
  worst.work = std::max(worst.work, -stress.dot(plastic) / (great * great / 1000));
  if (strength.values.friction_deg != strength.values.dilation_deg) return;
  // Any stress inside is on the other side of the plane through σ across the flow.
  const Eigen::Vector3d inside = stress_on_surface(surface, 0, random_trial(random) / 1e4 * size, modulus);
  const double reach = std::max(great, inside.cwiseAbs().maxCoeff());
  worst.flow = std::max(worst.flow, (inside - stress).dot(plastic) / (reach * reach / 1000));
}

}  // namespace

// pla-04: E 1000, ν 0.25, c 2, φ 30; figures have 12 digits.
TEST(YieldLaw, mohr_coulomb_returns_the_vectors_of_the_benchmark) {
  struct Row {
    std::array<double, 3> trial, associated, none, ten;
  };
  constexpr std::array<Row, 8> rows = {{
      {{-1, -5, -30},
       {-7.69059892324, -7.69059892324, -30.0},
       {-5.81435935394, -5.81435935394, -24.3712812921},
       {-6.64716152143, -6.64716152143, -26.8696877946}},
      {{5, -5, -20},
       {-4.35726558991, -7.33931639748, -20.0},
       {-2.01794919243, -5.0, -12.9820508076},
       {-3.05629621279, -6.03834702035, -16.0970918686}},
      {{10, 9.9, -20},
       {-4.35726558991, -4.35726558991, -20.0},
       {1.36564064606, 1.36564064606, -2.83128129211},
       {-1.17457265912, -1.17457265912, -10.4519212076}},
      {{2, -30, -30.5},
       {-8.19888583295, -31.5248607291, -31.5248607291},
       {-6.37765621992, -26.06117189, -26.06117189},
       {-7.22712078027, -28.6095655711, -28.6095655711}},
      {{20, 18, 15},
       {3.46410161514, 3.46410161514, 3.46410161514},
       {3.46410161514, 3.46410161514, 3.46410161514},
       {3.46410161514, 3.46410161514, 3.46410161514}},
      {{3, 1, -2},
       {1.64273441009, 0.660683602523, -2.0},
       {1.98205080757, 1.0, -0.982050807569},
       {1.83143921409, 0.84938840652, -1.43388558801}},
      {{0, 0, -10},
       {-1.02393225657, -1.02393225657, -10.0},
       {-0.614359353945, -0.614359353945, -8.77128129211},
       {-0.796155541721, -0.796155541721, -9.31666985544}},
      {{-10, -20, -60},
       {-17.6905989232, -21.9226497308, -60.0},
       {-15.7679491924, -20.0, -54.2320508076},
       {-16.6213513322, -20.8534021398, -56.7922572268}},
  }};
  const Eigen::Matrix3d modulus = principal_modulus();
  for (const Row& row : rows)
    for (const auto& [dilation, expected] : {std::pair{30.0, row.associated}, {0.0, row.none}, {10.0, row.ten}}) {
      const Strength strength = mohr_coulomb(30, dilation, 2);
      const Eigen::Vector3d trial(row.trial[0], row.trial[1], row.trial[2]);
      const Eigen::Vector3d stress = stress_on_surface({strength, kInfinite}, 0, trial, modulus);
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(stress(i), expected[static_cast<std::size_t>(i)], 5e-11 * 60) << trial.transpose();
    }
}

// pla-05: σy 10; and the constants of the cones at c = 1.
TEST(YieldLaw, von_mises_returns_the_vectors_of_the_benchmark) {
  struct Row {
    std::array<double, 3> trial, result;
  };
  constexpr std::array<Row, 6> rows = {{{{-1, -5, -30}, {-7.95904902896, -9.4284857457, -18.6124652253}},
                                        {{5, -5, -20}, {-1.31363287635, -5.90194755376, -12.7844195699}},
                                        {{10, 9.9, -20}, {3.31668048581, 3.28329164376, -6.69997212957}},
                                        {{2, -30, -30.5}, {-12.8339341775, -22.755520518, -22.9105453045}},
                                        {{20, 18, 15}, {20.0, 18.0, 15.0}},
                                        {{-10, -20, -60}, {-25.6356421953, -27.8178210976, -36.5465367071}}}};
  const Strength strength = von_mises(10);
  for (const Row& row : rows) {
    const Eigen::Vector3d stress = stress_on_surface(
        {strength, kInfinite}, 0, Eigen::Vector3d(row.trial[0], row.trial[1], row.trial[2]), principal_modulus());
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(stress(i), row.result[static_cast<std::size_t>(i)], 5e-11 * 60);
  }
}

TEST(YieldLaw, cones_have_the_constants_of_their_matching) {
  struct Row {
    double phi;
    std::array<double, 6> constants;
  };
  constexpr std::array<Row, 4> rows = {
      {{10, {0.0709436251553, 1.20702387468, 0.0631801740507, 1.07493771736, 0.0575940042887, 0.979895488325}},
       {20, {0.148583083744, 1.2246860025, 0.118171293618, 0.974018882531, 0.111846965088, 0.921891033044}},
       {30, {0.230940107676, 1.2, 0.164957219768, 0.857142857143, 0.160128153805, 0.832050294338}},
       {40, {0.314874977757, 1.12576015788, 0.203752531988, 0.728468435991, 0.200875760253, 0.71818322684}}}};
  for (const Row& row : rows) {
    const std::array cones = {cone_of(ConeMatching::compression, 1, row.phi),
                              cone_of(ConeMatching::extension, 1, row.phi),
                              cone_of(ConeMatching::plane_strain, 1, row.phi)};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(cones[i].slope, row.constants[2 * i], 1e-12);
      EXPECT_NEAR(cones[i].strength, row.constants[2 * i + 1], 1e-11);
    }
  }
}

TEST(YieldLaw, a_million_random_trials_come_to_the_surface) {
  std::mt19937_64 random(21);
  const std::vector<Strength> all = all_surfaces();
  const int trials = 1000000 / static_cast<int>(all.size()) + 1;
  for (const Strength& strength : all) {
    Worst worst;
    for (int i = 0; i < trials && !::testing::Test::HasFatalFailure(); ++i)
      check_trial(strength, random_trial(random), random, worst);
    const double smallest = strength.values.friction_deg == 1e-6 ? 1e-12 : 1e-14;
    SCOPED_TRACE("phi " + std::to_string(strength.values.friction_deg) + ", psi " +
                 std::to_string(strength.values.dilation_deg) + ", c " + std::to_string(strength.values.cohesion) +
                 ", T " + std::to_string(strength.values.tensile_strength.value_or(-1)));
    EXPECT_LT(worst.surface, smallest);
    EXPECT_EQ(worst.order, 0);
    EXPECT_LT(worst.work, 1e-13);  // rounding of the trial stress, as many times as a side is steep
    EXPECT_LT(worst.flow, 1e-12);
  }
}

namespace {

/// Largest difference of a tangent to central differences, over that of the modulus; `kink` if a difference crosses
/// from one region to another.
double tangent_error(const YieldLaw& law, const Eigen::Vector4d& increment, const YieldState& before, bool& kink) {
  const Response r = respond(law, increment, before, 1);
  const double step = 1e-6 * increment.norm();
  double error = 0;
  kink = false;
  for (int j = 0; j < 4; ++j) {
    Eigen::Vector4d forth = increment, back = increment;
    forth(j) += step;
    back(j) -= step;
    const Response a = respond(law, forth, before, 1), b = respond(law, back, before, 1);
    kink = kink || a.after.region != r.after.region || b.after.region != r.after.region;
    error = std::max(error, ((a.stress - b.stress) / (2 * step) - r.tangent.col(j)).cwiseAbs().maxCoeff());
  }
  return error / law.modulus()(0, 0);
}

}  // namespace

TEST(YieldLaw, tangents_are_the_derivatives_in_all_regions) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Strength> all = all_surfaces();
  for (Strength s : {mohr_coulomb(30, 10, 2), mohr_coulomb(30, 10, 2, 0.5), von_mises(10),
                     cone(ConeMatching::extension, 30, 10, 2)}) {
    s.change = StrengthChange{.values = s.values, .plastic_strain = 0.3};
    s.change->values.cohesion /= 2;
    s.change->values.friction_deg *= 0.8;
    s.change->values.dilation_deg = 0;
    s.change->values.yield_stress *= 1.5;
    all.push_back(s);
  }
  std::array<int, 5> seen{};
  for (const Strength& strength : all) {
    const YieldLaw law = law_of(strength);
    if (surface_scale({strength, kInfinite}, 0) < 1e-3) continue;  // differences of so little are rounding
    for (int i = 0; i < 200; ++i) {
      YieldState before;
      before.elastic = 0.002 * Eigen::Vector4d(unit(random), unit(random), unit(random), unit(random));
      before.kappa = 0.01 * (1 + unit(random));
      Eigen::Vector4d increment = 0.02 * Eigen::Vector4d(unit(random), unit(random), unit(random), unit(random));
      if (i % 4 == 0) increment(2) *= 1e-9;  // the axes of the plane
      if (i % 8 == 0) increment(1) = increment(0);
      bool kink = false;
      const double error = tangent_error(law, increment, before, kink);
      if (kink) continue;
      ++seen[static_cast<std::size_t>(respond(law, increment, before, 1).after.region)];
      // One in some thousands lies so near to a corner that its differences cross it within one region.
      EXPECT_LT(error, 1e-7) << "phi " << strength.values.friction_deg << " increment " << increment.transpose();
    }
  }
  for (const int count : seen) EXPECT_GT(count, 50);
}

namespace {

/// A point pulled or pressed along y with the stress along x kept, as pla-02 does; zz free or fixed.
struct Driven {
  YieldLaw law;
  YieldState state = {};
  bool across_free = false;
  Eigen::Vector4d stress = Eigen::Vector4d::Zero();
  double along = 0, work = 0;

  /// Strains xx (and zz alike if it is free) that keep their stress, found between bounds.
  void strain_to(double target, double kept) {
    const double step = target - along;
    const auto at = [&](double lateral) {
      return respond(law, {lateral, step, 0, across_free ? lateral : 0}, state, 1);
    };
    double reach = std::abs(step) + 1e-12, low = -reach, high = reach;
    while (at(low).stress(0) > kept && reach < 10) low = -(reach *= 2);
    while (at(high).stress(0) < kept && reach < 1e6) high = (reach *= 2);
    for (int i = 0; i < 200 && low < high; ++i) {
      const double middle = low + (high - low) / 2;
      if (middle == low || middle == high) break;
      (at(middle).stress(0) < kept ? low : high) = middle;
    }
    const Response r = at(high);
    work += (r.stress + stress).dot(Eigen::Vector4d(high, step, 0, across_free ? high : 0)) / 2;
    state = r.after;
    stress = r.stress;
    along = target;
  }
};

}  // namespace

// pla-01: uniaxial strengths 2 c tan(45 + φ/2) and 2 c / tan(45 + φ/2).
TEST(YieldLaw, a_free_bar_has_the_uniaxial_strengths_of_coulomb) {
  struct Row {
    double cohesion, phi, pressed, pulled;
  };
  for (const Row& row : {Row{10, 0, 20, 20}, Row{10, 30, 34.6410161514, 11.5470053838},
                         Row{5, 45, 24.1421356237, 4.14213562373}, Row{2, 20, 5.71259202697, 2.80083015284}})
    for (const double dilation : {0.0, row.phi}) {
      Driven pressed{law_of(mohr_coulomb(row.phi, dilation, row.cohesion)), {}, true};
      for (int i = 1; i <= 10; ++i) pressed.strain_to(-0.01 * i, 0);
      EXPECT_NEAR(pressed.stress(1), -row.pressed, 1e-9 * row.pressed);
      Driven pulled{law_of(mohr_coulomb(row.phi, dilation, row.cohesion)), {}, true};
      for (int i = 1; i <= 10; ++i) pulled.strain_to(0.002 * i, 0);
      EXPECT_NEAR(pulled.stress(1), row.pulled, 1e-9 * row.pulled);
    }
}

// pla-02: E 1000, ν 0.25, c 2, φ 30, ψ 0, plane strain.
TEST(YieldLaw, cycles_at_constant_lateral_stress) {
  struct Leg {
    double strain, sy, sz;
  };
  Driven a{law_of(mohr_coulomb(30, 0, 2))};
  for (const Leg& leg : {Leg{-0.004, -4.26666666667, -1.06666666667}, Leg{-0.010, -6.92820323028, -1.73205080757},
                         Leg{-0.006, -2.66153656361, -0.665384140902}, Leg{0, 2.30940107676, 0.57735026919},
                         Leg{0.004, 2.30940107676, 0.57735026919}, Leg{-0.004, -6.22393225657, -1.55598306414}}) {
    a.strain_to(leg.strain, 0);
    EXPECT_NEAR(a.stress(1), leg.sy, 1e-9 * 7) << leg.strain;
    EXPECT_NEAR(a.stress(3), leg.sz, 1e-9 * 7) << leg.strain;
  }
  Driven b{law_of(mohr_coulomb(30, 0, 2))};
  b.stress = Eigen::Vector4d(-5, -5, 0, -5);
  b.state.elastic = b.law.elastic_strain(b.stress);
  for (const Leg& leg : {Leg{-0.010, -15.6666666667, -7.66666666667}, Leg{-0.030, -21.9282032303, -9.23205080757},
                         Leg{-0.020, -11.2615365636, -6.5653841409}, Leg{-0.030, -21.9282032303, -9.23205080757}}) {
    b.strain_to(leg.strain, -5);
    EXPECT_NEAR(b.stress(1), leg.sy, 1e-9 * 22) << leg.strain;
    EXPECT_NEAR(b.stress(3), leg.sz, 1e-9 * 22) << leg.strain;
  }
}

// pla-03: uniaxial strain; A ν 0.1, ψ 0; B ν 0.25, ψ 30.
TEST(YieldLaw, oedometer_cycles_return_to_the_edge) {
  struct Leg {
    double strain, sx, sy;
  };
  const auto run = [](const YieldLaw& law, std::initializer_list<Leg> legs) {
    YieldState state;
    double at = 0;
    for (const Leg& leg : legs) {
      const Response r = respond(law, {0, leg.strain - at, 0, 0}, state, 1);
      EXPECT_NEAR(r.stress(0), leg.sx, 1e-9 * 28) << leg.strain;
      EXPECT_NEAR(r.stress(1), leg.sy, 1e-9 * 28) << leg.strain;
      EXPECT_NEAR(r.stress(3), leg.sx, 1e-9 * 28) << leg.strain;
      state = r.after;
      at = leg.strain;
    }
  };
  run(law_of(mohr_coulomb(30, 0, 2), 0.1), {{-0.005, -0.568181818182, -5.11363636364},
                                            {-0.01, -1.13636363636, -10.2272727273},
                                            {-0.02, -3.61435935394, -17.7712812921},
                                            {-0.01, -2.47799571758, -7.54400856484},
                                            {0, -0.989743318611, 1.97948663722}});
  run(law_of(mohr_coulomb(30, 30, 2)), {{0.002, 0.8, 2.4},
                                        {0.005, 1.60557405349, 2.84459242792},
                                        {-0.005, -2.39442594651, -9.15540757208},
                                        {-0.02, -8.39442594651, -27.1554075721},
                                        {0, -0.39442594651, -3.15540757208}});
}

// pla-06: s1 = N s3 + 2 c √N under triaxial compression, compression positive there.
TEST(YieldLaw, triaxial_strength) {
  struct Row {
    double phi, c, s3, s1;
  };
  for (const Row& row : {Row{30, 0, 100, 300}, Row{30, 20, 100, 369.282032303}, Row{35, 5, 50, 203.718437877},
                         Row{45, 10, 5, 77.4264068712}, Row{20, 10, 0, 28.5629601348}}) {
    Driven test{law_of(mohr_coulomb(row.phi, 0, row.c)), {}, true};
    test.stress = Eigen::Vector4d(-row.s3, -row.s3, 0, -row.s3);
    test.state.elastic = test.law.elastic_strain(test.stress);
    for (int i = 1; i <= 20; ++i) test.strain_to(-0.1 * i, -row.s3);
    EXPECT_NEAR(test.stress(1), -row.s1, 1e-9 * row.s1);
  }
}

// Work of a bar that loses all its strength: G_f over its size.
TEST(YieldLaw, softening_takes_the_fracture_energy) {
  for (const double size : {0.5, 1.0})
    for (Strength strength : {von_mises(10), mohr_coulomb(30, 30, 2), mohr_coulomb(30, 0, 2)}) {
      strength.change = StrengthChange{.values = strength.values, .fracture_energy = 0.8};
      strength.change->values.cohesion = 0;
      strength.change->values.yield_stress = 1e-3;
      const YieldLaw law = law_of(strength);
      const double fall =
          compressive_strength(strength, strength.values) - compressive_strength(strength, strength.change->values);
      // The point is of size 1 in `Driven`; energy is scaled in its place.
      Driven bar{law, {}, true};
      bar.law.strength.change->fracture_energy = 0.8 / size;
      const double end = 2 * 0.8 / (size * fall) + 0.02;
      constexpr int kSteps = 4000;
      for (int i = 1; i <= kSteps; ++i) bar.strain_to(-end * i / kSteps, 0);
      // The residual 1e-3 of von Mises carries load to the end.
      EXPECT_NEAR(bar.work * size, 0.8, 0.8 * 2e-3);
      EXPECT_NEAR(strain_of_change(strength, size), strain_of_change(bar.law.strength, 1), 1e-15);
    }
}

TEST(YieldLaw, nothing_is_borne_across_a_plate) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const Strength& strength : all_surfaces()) {
    const YieldLaw law = law_of(strength);
    YieldState state;
    for (int i = 0; i < 400; ++i) {
      const Eigen::Vector3d increment = 0.01 * Eigen::Vector3d(unit(random), unit(random), unit(random));
      const Response r = respond_plane_stress(law, increment, state, 1);
      const double scale = std::max(r.stress.cwiseAbs().maxCoeff(), surface_scale({strength, kInfinite}, 0));
      // Rounding of the elastic trial stress remains if the strength is nearly zero.
      ASSERT_NEAR(r.stress(3), 0, 1e-11 * scale + 2e-14 * law.youngs_modulus * increment.norm())
          << "phi " << strength.values.friction_deg << " c " << strength.values.cohesion << " step " << i;
      state = r.after;
    }
  }
}

// A bar that is free in the plane and across it: E, the yield stress, and no lateral stress.
TEST(YieldLaw, a_plate_yields_at_its_uniaxial_strength) {
  const YieldLaw law = law_of(von_mises(10));
  YieldState state;
  // Flow of a bar halves across: lateral strain -ν of the elastic part and -1/2 of the plastic one.
  const Response r = respond_plane_stress(law, {-0.25 * 0.01 - 0.5 * 0.02, 0.03, 0}, state, 1);
  EXPECT_NEAR(r.stress(1), 10, 1e-9);
  EXPECT_NEAR(r.stress(0), 0, 1e-9);
  EXPECT_NEAR(r.after.kappa, 0.02, 1e-12);
}

TEST(Strength, what_cannot_be_is_refused) {
  EXPECT_EQ(why_unusable(mohr_coulomb(30, 0, 2)), "");
  EXPECT_NE(why_unusable(mohr_coulomb(30, 0, -2)).find("expected cohesion of strength: 0 or more, found -2"),
            std::string::npos);
  EXPECT_NE(
      why_unusable(mohr_coulomb(90, 0, 2)).find("expected friction_deg of strength: at least 0 and below 90 degrees"),
      std::string::npos);
  EXPECT_NE(why_unusable(von_mises(0)).find("yield_stress"), std::string::npos);
  Strength both = von_mises(10);
  both.change = StrengthChange{.values = both.values, .plastic_strain = 0.1, .fracture_energy = 1};
  EXPECT_NE(why_unusable(both).find("found both"), std::string::npos);
  Strength tresca;
  tresca.surface = YieldSurface::tresca;
  tresca.values.yield_stress = 5;  // which it does not read
  EXPECT_NE(why_unusable(tresca).find("expected cohesion of strength: greater than 0"), std::string::npos);
  EXPECT_NE(why_unusable(Strength{}).find("expected cohesion of strength: greater than 0"), std::string::npos);
  Strength weaker = mohr_coulomb(20, 20, 2);
  weaker.change = StrengthChange{.values = weaker.values, .plastic_strain = 0.1};
  weaker.change->values.friction_deg = 5;
  EXPECT_NE(sentence_of(doubts_of(weaker).front()).find("above friction_deg 5 after the change"), std::string::npos);
  EXPECT_EQ(doubts_of(mohr_coulomb(20, 30, 2)).size(), 1U);
  // Angles that a change leaves unchanged give no second doubt.
  Strength looser = mohr_coulomb(20, 30, 2);
  looser.change = StrengthChange{.values = looser.values, .fracture_energy = 1};
  looser.change->values.cohesion = 1;
  EXPECT_EQ(doubts_of(looser).size(), 1U);
}

TEST(Strength, snap_back_is_bounded_by_the_energy) {
  Strength strength = von_mises(10);
  strength.change = StrengthChange{.values = strength.values, .fracture_energy = 2};
  strength.change->values.yield_stress = 0.001;
  EXPECT_NEAR(largest_size(strength, 1000), 2 * 1000 * 2 / (9.999 * 9.999), 1e-12);
}

}  // namespace keyblock::yield_law_test
