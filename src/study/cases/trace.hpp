// Reruns a case and follows the trace of the Berkeley program step by step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "api/case_folder.hpp"

namespace keyblock::study {

/// How far two runs differ. Positions are relative to the greatest coordinate of the trace, stresses to its greatest
/// stress, rotation in radians.
struct TraceDifference {
  std::string name;
  int steps = 0;  ///< compared
  int steps_in_trace = 0;
  int rows = 0;                      ///< of blocks, compared
  std::vector<std::string> unequal;  ///< first place of each thing that must be equal and is not
  double polygon = 0;                ///< vertices after cutting
  double position = 0;               ///< centroids and displacements
  double rotation = 0;
  double stress = 0;
  double disp_ratio = 0;  ///< displacement ratio, relative to its greatest (the trace has 6 digits)

  /// Everything equal that must be, and polygons, positions, rotations and stresses within `kTraceTolerance`.
  bool holds() const;
};

/// Demanded of profile `legacy` (relative, or radians); an independent replica of the rules reached 3e-9.
inline constexpr double kTraceTolerance = 1e-6;

TraceDifference follow_trace(const CaseFolder& folder);

}  // namespace keyblock::study
