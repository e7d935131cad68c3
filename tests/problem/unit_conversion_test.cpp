// Units against tables: the SI brochure, and the yard and pound agreement of 1959 with the values of NIST SP 811.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/units/unit_conversion.hpp"

#include <gtest/gtest.h>

namespace keyblock::unit_conversion_test {
namespace {

double factor_of(const char* name) {
  const std::optional<Unit> unit = unit_named(name);
  return unit ? unit->factor : 0;
}

}  // namespace

// NIST SP 811 (2008), appendix B, to the seven digits printed there: half a unit of the last is 5e-7 at most.
TEST(UnitConversion, factors_are_those_of_the_tables) {
  const std::pair<const char*, double> table[] = {{"GPa", 1e9},
                                                  {"MPa", 1e6},
                                                  {"kN/m", 1e3},
                                                  {"kN/m3", 1e3},
                                                  {"t/m3", 1e3},
                                                  {"mm", 1e-3},
                                                  {"km", 1e3},
                                                  {"ms", 1e-3},
                                                  {"min", 60},
                                                  {"h", 3600},
                                                  {"in", 2.54e-2},
                                                  {"ft", 0.3048},
                                                  {"yd", 0.9144},
                                                  {"lb", 4.5359237e-1},
                                                  {"slug", 14.59390},
                                                  {"lbf", 4.448222},
                                                  {"psi", 6.894757e3},
                                                  {"ksi", 6.894757e6},
                                                  {"psf", 47.88026},
                                                  {"bar", 1e5},
                                                  {"pcf", 157.0875},
                                                  {"kgf", 9.80665},
                                                  {"g/cm3", 1e3},
                                                  {"m/s2", 1},
                                                  {"cm/s^2", 1e-2},
                                                  {"MN/m/m", 1e6},
                                                  {"N/mm²", 1e6},
                                                  {"kip", 4.448222e3},
                                                  {"Mg", 1e3},
                                                  {"kt", 1e6},
                                                  {"tonne", 1e3},
                                                  {"g", 1e-3},
                                                  {"µm", 1e-6},
                                                  {"day", 86400},
                                                  {"year", 31557600},
                                                  {"N·mm", 1e-3},
                                                  {"kN·m/m", 1e3},
                                                  {"MPa√m", 1e6},
                                                  {"MPa·m^0.5", 1e6},
                                                  {"N/mm^1.5", 3.162278e4},
                                                  {"kN/m^1.5", 1e3},
                                                  {"s^-1", 1},
                                                  {"1/s", 1},
                                                  {"1/ms", 1e3},
                                                  {"rad/s", 1},
                                                  {"deg/s", 1.745329e-2},
                                                  {"ksi·in^0.5", 1.098843e6},
                                                  {"t·m²/m", 1e3},
                                                  {"lbf·ft", 1.355818},
                                                  {"km/h", 0.2777778}};
  for (const auto& [name, factor] : table) EXPECT_NEAR(factor_of(name) / factor, 1, 5e-7) << name;
}

TEST(UnitConversion, what_is_no_unit_is_none) {
  for (const char* name :
       {"", "GP", "gigapascal", "m/", "/s", "deg2", "s/deg", "kmin", "m4", "m^", "1", "√", "m*", "m^x", "1*", "2/s"})
    EXPECT_FALSE(unit_named(name)) << name;
}

TEST(UnitConversion, dimensions_multiply) {
  EXPECT_EQ(unit_named("kN/m2")->dimension, kStress);
  EXPECT_EQ(unit_named("Pa*m/m")->dimension, kStress);
  EXPECT_EQ(unit_named("kN/m3")->dimension, kForcePerVolume);
  EXPECT_EQ(unit_named("J/m2")->dimension, kForcePerLength);
  EXPECT_EQ(unit_named("MPa√m")->dimension, kToughness);
  EXPECT_EQ(unit_named("N/mm^1.5")->dimension, kToughness);
  EXPECT_EQ(unit_named("rad/s")->dimension, kRate);
}

// 1 MPa is 1 t mm / (s² mm²): with millimetre, tonne and second the unit of stress is the megapascal.
TEST(UnitConversion, base_units_of_a_case_make_its_derived_ones) {
  EXPECT_NEAR(*si_factor({"mm", "t", "s"}, kStress) / 1e6, 1, 1e-15);
  EXPECT_NEAR(*si_factor({"mm", "t", "s"}, kDensity) / 1e12, 1, 1e-15);
  EXPECT_NEAR(*si_factor({"m", "t", "s"}, kStress) / 1e3, 1, 1e-15);
  EXPECT_NEAR(*si_factor({"ft", "slug", "s"}, kStress) / 47.88026, 1, 5e-7);
  EXPECT_FALSE(si_factor({"m", "", "s"}, kStress));
  EXPECT_TRUE(si_factor({"m", "", "s"}, kAcceleration));
}

// kN, m, s: mass in kN s²/m, a tonne; MPa, m, s: in MPa m s², 1000 tonnes; lbf, in, s: lbf s²/in, 386.0886 lb (the
// acceleration of gravity in in/s²: 9.80665/0.0254).
TEST(UnitConversion, a_unit_of_force_or_stress_stands_for_that_of_mass) {
  EXPECT_EQ(mass_of_force("kN", "m", "s"), "t");
  EXPECT_EQ(mass_of_force("N", "m", "s"), "kg");
  EXPECT_EQ(mass_of_force("N", "mm", "s"), "t");
  EXPECT_EQ(mass_of_force("lbf", "ft", "s"), "slug");
  EXPECT_EQ(mass_of_stress("MPa", "m", "s"), "kt");
  EXPECT_EQ(mass_of_stress("MPa", "mm", "s"), "t");
  const std::string slinch = mass_of_force("lbf", "in", "s");
  EXPECT_EQ(slinch, "lbf·s²/in");
  EXPECT_NEAR(unit_named(slinch)->factor / (9.80665 / 0.0254 * 0.45359237), 1, 1e-15);
  EXPECT_EQ(mass_of_force("kN", "", "s"), "");
}

TEST(UnitConversion, a_value_is_a_number_and_a_unit) {
  EXPECT_EQ(quantity_in("20 GPa")->number, 20);
  EXPECT_EQ(quantity_in("20 GPa")->unit, "GPa");
  EXPECT_EQ(quantity_in("1.5e-3m")->unit, "m");
  for (const char* text : {"20", "GPa", "20 G Pa", "nan GPa", ""}) EXPECT_FALSE(quantity_in(text)) << text;
}

}  // namespace keyblock::unit_conversion_test
