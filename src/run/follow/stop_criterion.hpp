// Describes the quantity of a history at whose limit a run stops.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "run/follow/followed.hpp"

namespace keyblock {

/// Limit of a quantity of a history: `crest.dx > 0.05`.
struct StopCriterion {
  std::string words;     ///< as the user wrote it
  std::string history;   ///< name in histories.csv
  std::string quantity;  ///< "displacement_x"; "displacement" is the length of the displacement
  bool is_above = true;  ///< stops above the limit, otherwise below it
  double limit = 0;      ///< in the units of the case

  /// Returns "crest.displacement_x is 0.0512 m, above 0.05 m" if one of the followed values meets the criterion,
  /// otherwise an empty text. Throws InputError if there is no such quantity.
  std::string met_by(const std::vector<FollowedValue>& values) const;
};

/// Returns the name in histories.csv of a short one: "displacement_x" of dx; the name itself if it is not short.
std::string long_quantity(const std::string& name);

/// Parses `NAME.QUANTITY>VALUE` or `NAME.QUANTITY<VALUE`. QUANTITY is a column value of histories.csv, or short: d, dx,
/// dy, vx, vy, r. VALUE is a number, or one with a unit for d, dx, dy, vx and vy: `crest.dx>5 cm`. Throws
/// std::invalid_argument.
StopCriterion stop_criterion_of(const std::string& text, const Units& units);

}  // namespace keyblock
