// Reads columns of the tables of a run, and draws them as curves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "problem/units/measure.hpp"

namespace keyblock {

/// Columns of one or several tables, over the time or over another column.
struct CurveRequest {
  std::vector<std::string> names;  ///< as `recorded_names` lists them
  std::string against = "time";
};

/// Returns the names of all curves of a run: columns of history.csv and ledger.csv ("dx1", "kinetic"), and rows of
/// histories.csv by their name and quantity ("crest.displacement_x").
std::vector<std::string> recorded_names(const std::filesystem::path& folder);

/// Returns the picture of the curves. All names must have one unit. An empty title takes no room. `wide`: width of the
/// page in its units, in which letters are 11 to 17 high. Throws UsageError for a name that the run does not have, or
/// for two units.
std::string recorded_picture(const std::filesystem::path& folder, const CurveRequest& request, const std::string& title,
                             const Units& units, double wide = 900);

}  // namespace keyblock
