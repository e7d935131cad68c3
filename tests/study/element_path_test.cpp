// A single element on paths of strain and stress compared with the benchmarks pla-02, pla-03 and pla-06.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/element/element_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace keyblock::study {
namespace {

YieldLaw rock(double friction, double dilation, double cohesion, double poissons_ratio = 0.25) {
  Strength s;
  s.values = {.cohesion = cohesion, .friction_deg = friction, .dilation_deg = dilation};
  return {1000, poissons_ratio, s};
}

/// The point at the end of each leg.
std::vector<ElementPoint> ends(const ElementCurve& curve) {
  std::vector<ElementPoint> found;
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    if (i + 1 == curve.points.size() || curve.points[i + 1].leg != curve.points[i].leg)
      found.push_back(curve.points[i]);
  return found;
}

formats::CsvTable table(const std::string& text) {
  return formats::read_csv({"path.csv", text});
}

}  // namespace

TEST(ElementPath, cycles_with_free_sides_in_plane_strain) {
  const ElementPath path = named_path(NamedPath::biaxial, {-0.004, -0.010, -0.006, 0, 0.004, -0.004}, 0);
  for (const int steps : {1, 50}) {
    const ElementCurve curve = drive(rock(30, 0, 2), path, steps, 1);
    ASSERT_EQ(curve.failure, "");
    const std::vector<ElementPoint> found = ends(curve);
    constexpr std::array<double, 6> kAxial{-4.26666666667, -6.92820323028, -2.66153656361,
                                           2.30940107676,  2.30940107676,  -6.22393225657};
    ASSERT_EQ(found.size(), kAxial.size());
    for (std::size_t i = 0; i < kAxial.size(); ++i) EXPECT_NEAR(found[i].stress(1), kAxial[i], 1e-9 * 7) << i;
  }
}

// pla-12: loaded, unloaded to zero, reloaded onto the plateau, unloaded from there, reloaded. Unloading has E2 down to
// the stress at which cracks open, 5, then E1; the plateau leaves its flow, 1e-3, behind.
TEST(ElementPath, cracks_close_and_open_under_uniaxial_stress) {
  YieldLaw law = rock(30, 0, 80 * (1 - 0.5) / (2 * std::cos(std::numbers::pi / 6)));
  law.youngs_modulus = 30e3;
  law.closure = CrackClosure{10e3, 5e-4};
  const ElementPath path =
      named_path(NamedPath::uniaxial,
                 {-5e-4, -1e-3, -2e-3, -5e-4, 0, -2e-3, -3e-3, -4e-3, -1.5e-3, -1e-3, -1.5e-3, -4e-3, -5e-3}, 0);
  constexpr std::array<double, 13> kAxial{-5, -20, -50, -5, 0, -50, -80, -80, -5, 0, -5, -80, -80};
  for (const int steps : {1, 20}) {
    const ElementCurve curve = drive(law, path, steps, 1);
    ASSERT_EQ(curve.failure, "");
    const std::vector<ElementPoint> found = ends(curve);
    ASSERT_EQ(found.size(), kAxial.size());
    for (std::size_t i = 0; i < kAxial.size(); ++i) EXPECT_NEAR(found[i].stress(1), kAxial[i], 1e-9 * 80) << i;
    for (const ElementPoint& point : found) EXPECT_NEAR(point.stress(0), 0, 1e-9 * 80);
    EXPECT_NEAR(found[7].plastic_work, 80 * 1e-3, 1e-9);
    EXPECT_NEAR(found[2].strain(0), 0.25 * 50 / 30e3, 1e-12);
  }
}

TEST(ElementPath, cycles_under_confinement) {
  const ElementCurve curve =
      drive(rock(30, 0, 2), named_path(NamedPath::biaxial, {-0.010, -0.030, -0.020, -0.030}, 5), 20, 1);
  ASSERT_EQ(curve.failure, "");
  const std::vector<ElementPoint> found = ends(curve);
  constexpr std::array<double, 4> kAxial{-15.6666666667, -21.9282032303, -11.2615365636, -21.9282032303};
  for (std::size_t i = 0; i < kAxial.size(); ++i) EXPECT_NEAR(found[i].stress(1), kAxial[i], 1e-9 * 22) << i;
}

TEST(ElementPath, oedometer) {
  const ElementCurve curve =
      drive(rock(30, 30, 2), named_path(NamedPath::oedometer, {0.002, 0.005, -0.005, -0.02, 0}, 0), 7, 1);
  const std::vector<ElementPoint> found = ends(curve);
  constexpr std::array<double, 5> kAxial{2.4, 2.84459242792, -9.15540757208, -27.1554075721, -3.15540757208};
  for (std::size_t i = 0; i < kAxial.size(); ++i) EXPECT_NEAR(found[i].stress(1), kAxial[i], 1e-9 * 28) << i;
}

TEST(ElementPath, triaxial_strength) {
  struct Row {
    double phi, cohesion, confining, strength;
  };
  for (const Row& row : {Row{30, 0, 100, 300}, Row{30, 20, 100, 369.282032303}, Row{35, 5, 50, 203.718437877},
                         Row{45, 10, 5, 77.4264068712}, Row{20, 10, 0, 28.5629601348}}) {
    const ElementCurve curve =
        drive(rock(row.phi, 0, row.cohesion), named_path(NamedPath::triaxial, {-2}, row.confining), 40, 1);
    ASSERT_EQ(curve.failure, "") << row.phi;
    EXPECT_NEAR(curve.points.back().stress(1), -row.strength, 1e-9 * row.strength);
    EXPECT_NEAR(curve.points.back().stress(0), -row.confining, 1e-9 * row.strength);
  }
}

// Equal pressures on two sides leave two equal strains. With these constants an increment of axial strain alone only
// just reaches the edge, k λ = λ + 2G (at 30 degrees and a ratio of 0.25): rounding would choose a plane. κ of the
// strain (1, ½, ½) less the elastic one, of flow without dilation.
TEST(ElementPath, equal_pressures_leave_equal_strains) {
  for (const int steps : {10, 30, 100, 1000}) {
    const ElementCurve curve = drive(rock(30, 0, 1), named_path(NamedPath::triaxial, {-0.02}, 5), steps, 1);
    const ElementPoint& end = curve.points.back();
    EXPECT_NEAR(end.strain(0), end.strain(3), 1e-13) << steps;
    const double elastic = (2 * std::sqrt(3.0) + 10) / 1000;
    EXPECT_NEAR(end.state.kappa, 0.02 - elastic, 1e-9) << steps;
  }
}

// 2c of half the shear stress: under simple shear Tresca yields at c.
TEST(ElementPath, shear_yields_at_the_cohesion) {
  const ElementCurve curve = drive(rock(0, 0, 2), named_path(NamedPath::shear, {0.02}, 0), 10, 1);
  EXPECT_NEAR(curve.points.back().stress(2), 2, 1e-12);
  EXPECT_NEAR(curve.points.back().plastic_work, 2 * (0.02 - 2.0 / 400), 1e-12);
}

TEST(ElementPath, a_file_names_what_is_prescribed) {
  const ElementPath path = read_path(table("eyy,sxx,ezz\n-0.004,0,0\n-0.01,0,0\n"));
  ASSERT_EQ(path.legs.size(), 2U);
  EXPECT_TRUE(path.legs[0][0].is_stress);
  EXPECT_EQ(path.legs[1][1].target, -0.01);
  EXPECT_NEAR(drive(rock(30, 0, 2), path, 5, 1).points.back().stress(1), -6.92820323028, 1e-9 * 7);
  EXPECT_THROW(read_path(table("eyy,syy\n1,2\n")), InputError);
  EXPECT_THROW(read_path(table("strain\n1\n")), InputError);
  EXPECT_THROW(read_path(table("eyy\n")), InputError);
}

TEST(ElementPath, a_stress_that_no_strain_bears_ends_the_curve) {
  ElementPath path;
  path.legs.push_back({DrivenComponent{true, 0}, {true, -20}, {}, {true, 0}});
  const ElementCurve curve = drive(rock(30, 0, 2), path, 20, 1);
  EXPECT_NE(curve.failure.find("leg 1, step 7 of 20"), std::string::npos)
      << curve.failure;  // 6.93 is carried, 7 is not
  EXPECT_NEAR(curve.points.back().stress(1), -6, 1e-9);
}

TEST(ElementPath, its_table_has_a_row_a_point) {
  const std::string text = element_csv(drive(rock(30, 0, 2), named_path(NamedPath::uniaxial, {-0.01}, 0), 3, 1));
  EXPECT_EQ(std::ranges::count(text, '\n'), 5);
  EXPECT_TRUE(text.starts_with("leg,exx,eyy,gxy,ezz,sxx,syy,sxy,szz,s1,s2,s3,kappa,plastic_work,region\n"));
}

}  // namespace keyblock::study
