// Reruns a case and compares it with the trace of the Berkeley program step by step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "api/case_folder.hpp"

namespace keyblock::study {

/// Difference of two runs. Positions are relative to the greatest coordinate of the trace, stresses to its greatest
/// stress, rotation in radians.
struct TraceDifference {
  std::string name;
  int steps = 0;  ///< compared
  int steps_in_trace = 0;
  int rows = 0;                      ///< of blocks, compared
  std::vector<std::string> unequal;  ///< first place of each required equality that fails
  double polygon = 0;                ///< vertices after cutting
  double position = 0;               ///< centroids and displacements
  double rotation = 0;
  double stress = 0;
  double disp_ratio = 0;  ///< displacement ratio, relative to its greatest (the trace has 6 digits)

  /// Returns true if all required equalities hold, and polygons, positions, rotations and stresses are within
  /// `kTraceTolerance`.
  bool holds() const;
};

/// Tolerance of profile `legacy` (relative, or radians); an independent replica of the rules reached 3e-9.
inline constexpr double kTraceTolerance = 1e-6;

TraceDifference follow_trace(const CaseFolder& folder);

}  // namespace keyblock::study
