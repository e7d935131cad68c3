// The stress intensity of every tip of a case at the end of its run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "fracture/kink.hpp"
#include "fracture/tip_report.hpp"
#include "problem/problem.hpp"
#include "run/settings_of.hpp"

namespace keyblock::study {

/// A tip, and how near it is to going on.
struct TipAtEnd {
  TipReport report;
  Kink kink;
  std::optional<double> toughness;  ///< K_Ic of the rock there; none: its material has none
};

struct CaseIntensity {
  std::vector<TipAtEnd> tips;
  int unknowns = 0;
  double time = 0;            ///< at the end
  bool is_in_motion = false;  ///< in time; else an equilibrium
  std::string failure;        ///< why the run did not reach its end; empty where it did
  Warnings warnings;
};

/// Steps the case to its end and takes the integrals there; growth of its cracks is left out. Throws InputError for a
/// case without bodies on covers or without a tip in them, and as `prepare`.
CaseIntensity intensity_at_end(Problem problem, const std::string& profile, const std::vector<Override>& overrides,
                               const std::function<bool()>& wants_stop);

}  // namespace keyblock::study
