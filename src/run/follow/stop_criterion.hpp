// Describes the quantity of a history at whose limit a run stops.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/run_choices.hpp"

namespace keyblock {

/// Limit of a quantity of a history: `crest.dx > 0.05`.
struct StopCriterion {
  std::string words;     ///< as the user wrote it
  std::string history;   ///< name in histories.csv
  std::string quantity;  ///< "displacement_x"; "displacement" is the length of the displacement
  bool is_above = true;  ///< stops above the limit, otherwise below it
  double limit = 0;      ///< in the units of the case

  /// Returns "crest.displacement_x is 0.0512, above 0.05" if one of the rows of the followed quantities meets the
  /// criterion, otherwise an empty text. Throws InputError if no row has the quantity.
  std::string met_by(const std::string& rows) const;
};

/// Returns the name in histories.csv of a short one: "displacement_x" of dx; the name itself if it is not short.
std::string long_quantity(const std::string& name);

/// Parses `NAME.QUANTITY>VALUE` or `NAME.QUANTITY<VALUE`. QUANTITY is a column value of histories.csv, or short: d, dx,
/// dy, vx, vy, r. VALUE is a number, or one with a unit for d, dx, dy, vx and vy: `crest.dx>5 cm`. Throws
/// std::invalid_argument.
StopCriterion stop_criterion_of(const std::string& text, const Units& units);

}  // namespace keyblock
