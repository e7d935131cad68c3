// Names of the units of results, composed of those that a case declares.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/units/measure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock::measure_test {
namespace {

const Units kMetres{"m", "kg", "s"};
const Units kTonnes{"m", "t", "s"};
const Units kKilonewtons{"m", mass_of_force("kN", "m", "s"), "s"};
const Units kMillimetres{"mm", "t", "s"};
const Units kMegapascals{"m", mass_of_stress("MPa", "m", "s"), "s"};
const Units kFeet{"ft", "slug", "s"};
const Units kInches{"in", mass_of_force("lbf", "in", "s"), "s"};
const Units kPounds{"ft", "lb", "s"};
const Units kFeetPsi{"ft", mass_of_stress("psi", "ft", "s"), "s"};      // force: 144 lbf, without a name
const Units kCentimetres{"cm", mass_of_stress("MPa", "cm", "s"), "s"};  // 100 N

}  // namespace

// 1 t m/s² is 1 kN, 1 t mm/s² is 1 N, N/mm² are MPa, 1 slug ft/s² is 1 lbf.
TEST(Measure, units_are_named_by_those_that_the_case_declares) {
  struct Row {
    Measure measure;
    const char* metres;
    const char* kilonewtons;
    const char* millimetres;
    const char* megapascals;
    const char* letters;
  };
  const Row table[] = {{measures::kLength, "m", "m", "mm", "m", "L"},
                       {measures::kVelocity, "m/s", "m/s", "mm/s", "m/s", "L/T"},
                       {measures::kRotationRate, "rad/s", "rad/s", "rad/s", "rad/s", "rad/T"},
                       {measures::kStress, "Pa", "kPa", "MPa", "MPa", "F/L²"},
                       {measures::kForce, "N/m", "kN/m", "N/mm", "MN/m", "F"},
                       {measures::kEnergy, "N·m/m", "kN·m/m", "N·mm/mm", "MN·m/m", "F L"},
                       {measures::kStiffness, "N/m/m", "kN/m/m", "N/mm/mm", "MN/m/m", "F/L"},
                       {measures::kEnergyPerArea, "N/m", "kN/m", "N/mm", "MN/m", "F/L"},
                       {measures::kMomentum, "N·s/m", "kN·s/m", "N·s/mm", "MN·s/m", "F T"},
                       {measures::kAngularMomentum, "N·m·s/m", "kN·m·s/m", "N·mm·s/mm", "MN·m·s/m", "F L T"},
                       {measures::kToughness, "N/m^1.5", "kN/m^1.5", "N/mm^1.5", "MN/m^1.5", "F/L^1.5"},
                       {measures::kMass, "kg/m", "t/m", "t/mm", "kt/m", "M"},
                       {measures::kMomentOfInertia, "kg·m²/m", "t·m²/m", "t·mm²/mm", "kt·m²/m", "M L²"},
                       {measures::kDensity, "kg/m³", "t/m³", "t/mm³", "kt/m³", "M/L³"},
                       {measures::kDegrees, "deg", "deg", "deg", "deg", "deg"},
                       {measures::kNumber, "", "", "", "", ""}};
  for (const Row& row : table) {
    EXPECT_EQ(unit_of(row.measure, kMetres), row.metres);
    EXPECT_EQ(unit_of(row.measure, kKilonewtons), row.kilonewtons);
    EXPECT_EQ(unit_of(row.measure, kTonnes), row.kilonewtons);
    EXPECT_EQ(unit_of(row.measure, kMillimetres), row.millimetres);
    EXPECT_EQ(unit_of(row.measure, kMegapascals), row.megapascals);
    EXPECT_EQ(unit_of(row.measure, {}), row.letters);
  }
  EXPECT_EQ(unit_of(measures::kStress, kFeet), "psf");
  EXPECT_EQ(unit_of(measures::kForce, kFeet), "lbf/ft");
  EXPECT_EQ(unit_of(measures::kStress, kInches), "psi");
  EXPECT_EQ(unit_of(measures::kForce, kFeetPsi), "psi·ft²/ft");
  EXPECT_EQ(unit_of(measures::kDensity, kCentimetres), "MPa·cm²·s²/cm^4");
  EXPECT_EQ(unit_of(measures::kDensity, kInches), "lbf·s²/in^4");
  EXPECT_EQ(unit_of(measures::kStress, kPounds), "lb/ft/s²");  // the poundal has no name here
}

// A reader of a table may read a heading as a unit: its value is then the product of the units of the case.
TEST(Measure, a_name_is_worth_what_the_declared_units_make_of_it) {
  const Measure all[] = {measures::kLength,         measures::kArea,
                         measures::kTime,           measures::kVelocity,
                         measures::kAcceleration,   measures::kRotationRate,
                         measures::kRate,           measures::kStress,
                         measures::kDensity,        measures::kForcePerVolume,
                         measures::kToughness,      measures::kEnergyPerArea,
                         measures::kMass,           measures::kMomentOfInertia,
                         measures::kForce,          measures::kMoment,
                         measures::kStiffness,      measures::kMomentum,
                         measures::kAngularMomentum};
  for (const Units& units :
       {kMetres, kTonnes, kKilonewtons, kMillimetres, kMegapascals, kFeet, kInches, kPounds, kFeetPsi, kCentimetres})
    for (const Measure& measure : all) {
      const std::string name = unit_of(measure, units);
      const std::optional<Unit> unit = unit_named(name);
      ASSERT_TRUE(unit) << name;
      EXPECT_EQ(unit->dimension, dimension_of(measure)) << name;
      EXPECT_NEAR(unit->factor / *si_factor(units, dimension_of(measure)), 1, 1e-12) << name;
    }
}

// Against factors that were published: NIST Special Publication 811 (2008), appendix B, to its seven digits, and
// products of the exact ones of metre, kilogram and second.
TEST(Measure, names_are_worth_what_tables_of_conversion_say) {
  struct Row {
    const Units& units;
    Measure measure;
    const char* name;
    double si;
  };
  const Row table[] = {{kMetres, measures::kStress, "Pa", 1},
                       {kMetres, measures::kToughness, "N/m^1.5", 1},
                       {kKilonewtons, measures::kStress, "kPa", 1e3},
                       {kKilonewtons, measures::kMass, "t/m", 1e3},
                       {kKilonewtons, measures::kForcePerVolume, "kN/m³", 1e3},
                       {kMillimetres, measures::kStress, "MPa", 1e6},
                       {kMillimetres, measures::kForce, "N/mm", 1e3},
                       {kMillimetres, measures::kDensity, "t/mm³", 1e12},
                       {kMillimetres, measures::kMomentOfInertia, "t·mm²/mm", 1},
                       {kMegapascals, measures::kForce, "MN/m", 1e6},
                       {kMegapascals, measures::kDensity, "kt/m³", 1e6},
                       {kFeet, measures::kLength, "ft", 0.3048},
                       {kFeet, measures::kStress, "psf", 47.88026},
                       {kFeet, measures::kForce, "lbf/ft", 14.59390},
                       {kFeet, measures::kDensity, "slug/ft³", 515.3788},
                       {kFeet, measures::kMass, "slug/ft", 14.59390 / 0.3048},
                       {kInches, measures::kLength, "in", 0.0254},
                       {kInches, measures::kStress, "psi", 6894.757},
                       {kInches, measures::kForce, "lbf/in", 175.1268},
                       {kInches, measures::kAcceleration, "in/s²", 0.0254},
                       {kFeetPsi, measures::kStress, "psi", 6894.757},
                       {kPounds, measures::kStress, "lb/ft/s²", 1.488164},
                       {kPounds, measures::kDensity, "lb/ft³", 16.01846}};
  for (const Row& row : table) {
    EXPECT_EQ(unit_of(row.measure, row.units), row.name);
    EXPECT_NEAR(unit_named(row.name)->factor / row.si, 1, 5e-7) << row.name;
    EXPECT_NEAR(*si_factor(row.units, dimension_of(row.measure)) / row.si, 1, 5e-7) << row.name;
  }
}

TEST(Measure, what_is_not_declared_stays_a_letter) {
  EXPECT_EQ(with_unit("x", measures::kLength, {"m", "", ""}), "x [m]");
  EXPECT_EQ(with_unit("force", measures::kForce, {"m", "", ""}), "force [F]");
  EXPECT_EQ(with_unit("share", measures::kNumber, kMetres), "share");
  EXPECT_FALSE(is_declared(measures::kForce, {"m", "kg", ""}));
  EXPECT_TRUE(is_declared(measures::kForce, kMetres));
}

// Every example of a kind is one of that kind: a user can follow the message that shows it.
TEST(Measure, examples_are_values_of_their_kind) {
  for (const Measure& measure : {measures::kLength,
                                 measures::kArea,
                                 measures::kTime,
                                 measures::kVelocity,
                                 measures::kAcceleration,
                                 measures::kRotationRate,
                                 measures::kRate,
                                 measures::kStress,
                                 measures::kDensity,
                                 measures::kForcePerVolume,
                                 measures::kToughness,
                                 measures::kEnergyPerArea,
                                 measures::kMass,
                                 measures::kMomentOfInertia,
                                 measures::kForce,
                                 measures::kMoment,
                                 measures::kStiffness,
                                 measures::kMomentum,
                                 measures::kAngularMomentum,
                                 measures::kDegrees,
                                 measures::kRadians}) {
    const std::string_view value = example_value(measure);
    EXPECT_TRUE(converted(value, measure, kMetres).number) << value;
    EXPECT_NE(example_of(measure).find(value), std::string::npos);
  }
}

TEST(Measure, values_are_converted_into_the_units_of_the_case) {
  EXPECT_NEAR(*converted("1.5 MPa√m", measures::kToughness, kKilonewtons).number, 1500, 1e-9);
  EXPECT_NEAR(*converted("1.5 MPa√m", measures::kToughness, kMillimetres).number, 1.5 * std::sqrt(1000), 1e-12);
  EXPECT_NEAR(*converted("50 kN/m", measures::kForce, kMegapascals).number, 0.05, 1e-15);
  EXPECT_NEAR(*converted("90 deg/s", measures::kRotationRate, kMetres).number, std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(*converted("0.5 rad", measures::kDegrees, {}).number, 28.64788975654116, 1e-12);
  EXPECT_NEAR(*converted("180 deg", measures::kRadians, {}).number, std::numbers::pi, 1e-15);
  EXPECT_TRUE(converted("1 m", measures::kLength, {}).lacks_units);
  EXPECT_FALSE(converted("1 s", measures::kLength, kMetres).number);
  EXPECT_FALSE(converted("1 kN", measures::kForce, kMetres).number);  // of what thickness?
}

}  // namespace keyblock::measure_test
