// Units of a readable size: the prefix follows the number, undeclared units stay away.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/units/readable.hpp"

#include <gtest/gtest.h>

namespace keyblock::readable_test {

const Units kMetres{"m", "kg", "s"};
const Units kMillimetres{"mm", "t", "s"};

TEST(Readable, lengths_stresses_forces_and_times_take_the_prefix_that_fits) {
  EXPECT_EQ(readable(0.000775, measures::kLength, kMetres), "0.775 mm");
  EXPECT_EQ(readable(0.906, measures::kLength, kMetres), "0.906 m");
  EXPECT_EQ(readable(2500, measures::kLength, kMillimetres), "2.5 m");
  EXPECT_EQ(readable(-270123, measures::kStress, kMetres), "-270 kPa");
  EXPECT_EQ(readable(7.25, measures::kStress, kMillimetres), "7.25 MPa");
  EXPECT_EQ(readable(0.001, measures::kTime, kMetres), "1 ms");
  EXPECT_EQ(readable(0.98, measures::kVelocity, kMetres), "0.98 m/s");
  EXPECT_EQ(readable(3.88e-6, measures::kLength, kMetres), "3.88 µm");
  EXPECT_EQ(readable(0.5, measures::kLength, kMetres), "0.5 m") << "as on the page";
  EXPECT_EQ(readable(12500, measures::kForce, kMetres), "12.5 kN/m");
  EXPECT_EQ(readable(12500, measures::kEnergy, kMetres), "12.5 kJ/m");
}

TEST(Readable, what_is_not_declared_has_no_unit_and_three_digits) {
  EXPECT_EQ(readable(0.08232, measures::kLength, {}), "0.0823");
  EXPECT_EQ(readable(-3318529, measures::kStress, {}), "-3.32e+06");
  EXPECT_EQ(readable(0, measures::kStress, kMetres), "0 Pa");
}

}  // namespace keyblock::readable_test
