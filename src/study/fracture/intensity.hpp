// The stress intensity of every tip of a case at the end of its run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "api/plan.hpp"
#include "base/error.hpp"
#include "fracture/kink.hpp"
#include "fracture/tip_report.hpp"

namespace keyblock::study {

/// The same tip by the other treatment: near-tip functions in place of a mesh bisected towards it, or that in place of
/// functions.
struct OtherTreatment {
  double side = 0;  ///< of the mesh at the tip
  std::optional<TipFactors> factors;
};

/// A tip, and how near it is to going on.
struct TipAtEnd {
  TipReport report;
  Kink kink;
  std::optional<double> toughness;  ///< K_Ic of the rock there; none: its material has none
  std::optional<OtherTreatment> other = {};
};

/// Whether both treatments found factors.
bool has_both(const TipAtEnd& tip);
/// Of two treatments, how far they are apart over |K| by the case's own.
StressIntensity difference(const TipAtEnd& tip);
/// Why the factors of a tip cannot be trusted, in words: of the domains, then of the two treatments; empty where
/// nothing speaks against them.
std::string doubt_of(const TipAtEnd& tip);

struct CaseIntensity {
  std::vector<TipAtEnd> tips;
  int unknowns = 0;
  double time = 0;             ///< at the end
  bool is_in_motion = false;   ///< in time; else an equilibrium
  std::string failure;         ///< why the run did not reach its end; empty where it did
  bool has_functions = false;  ///< the case asks for near-tip functions
  int other_unknowns = 0;      ///< of the other treatment
  std::string no_other;        ///< why there is none; empty where there is
  Warnings warnings;
};

/// Steps the case to its end and takes the integrals there; growth of its cracks is left out. Then the same with the
/// other treatment of tips, where that can be: near-tip functions on sides of an eighth of the room about the narrowest
/// tip, or none on sides of 1/320 of it. Throws InputError for a case without bodies on covers or without a tip in
/// them, and as `prepared_case`.
CaseIntensity intensity_at_end(const ConfiguredCase& made);

}  // namespace keyblock::study
