// Computes the toughness of rock from failure loads of notched specimens, by the formulas of the standard tests.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "study/fit/measured.hpp"

namespace keyblock::study {

enum class ToughnessTest {
  chevron_bend,       ///< ISRM 1988 (Ouchterlony): diameter, span, notch, load
  semicircular_bend,  ///< ISRM 2014 (Kuruppu et al.): radius, thickness, notch, span, load
  notched_disc,       ///< chevron notched disc, ISRM 1995 (Fowell): diameter, thickness, notch (a0), end (a1), load
};

/// K_Ic of each specimen, and the mean of all with its error from their scatter.
struct ToughnessFit {
  std::vector<double> of_specimen;  ///< MPa√m if headings have units, else F/L^1.5 of the table
  Found mean;
  std::string unit;  ///< "MPa√m", or empty
};

/// Evaluates one row per specimen, with columns found by their headings; lengths and loads all have units there, or
/// none:
///     chevron_bend       K = A F / D^1.5, A = (1.835 + 7.15 a/D + 9.85 (a/D)²) S/D
///     semicircular_bend  K = F √(π a) Y / (2 R B), with b = a/R and s = S/(2R)
///                        Y = -1.297 + 9.516 s - (0.47 + 16.457 s) b + (1.071 + 34.401 s) b²
///     notched_disc       K = F Y / (B √D), Y = 0.2667 exp(1.7676 α1), α1 = 2 a1/D, of the standard specimen
/// Later calibrations of the last are some 12 % higher (Kaklis et al. 2017). Throws InputError for missing columns or
/// units, no specimen, and proportions outside the range of a formula.
ToughnessFit fit_toughness(const formats::CsvTable& tests, ToughnessTest test);

}  // namespace keyblock::study
