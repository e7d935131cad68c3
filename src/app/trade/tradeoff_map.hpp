// Declares the map of errors of `keyblock tradeoff --map`: every contact stiffness with every step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/trade/study_options.hpp"

namespace keyblock {

struct MapOptions : StudyOptions {
  std::vector<double> penalties{100, 10, 1, 0.1, 0.01};  ///< factors of the case's own
  std::vector<double> steps{4, 2, 1, 0.5, 0.25};         ///< factors of the case's own
  std::string table;                                     ///< file; empty: none
};

/// Runs all pairs, prints the map, and writes its table and picture. Throws UsageError, InputError.
ExitCode map_errors(const MapOptions& options);

}  // namespace keyblock
