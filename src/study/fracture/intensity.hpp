// Computes the stress intensity factors of every tip of a case at the end of its run. Theory:
// docs/theory/10-fracture.md.
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

/// Same tip by the other treatment: near-tip functions instead of a mesh bisected towards it, or the reverse.
struct OtherTreatment {
  double side = 0;  ///< of the mesh at the tip
  std::optional<TipFactors> factors;
};

/// Tip at the end of a run, and the kink in which it would extend.
struct TipAtEnd {
  TipReport report;
  Kink kink;
  std::optional<double> toughness;  ///< K_Ic of the rock there; empty if its material has none
  std::optional<OtherTreatment> other = {};
};

/// Returns true if both treatments found stress intensity factors.
bool has_both(const TipAtEnd& tip);
/// Returns the difference of the two treatments over |K| of the case's own.
StressIntensity difference(const TipAtEnd& tip);
/// Explains why the factors of a tip are unreliable: by their domains, then by the two treatments. Empty if nothing
/// speaks against them.
std::string doubt_of(const TipAtEnd& tip);

struct CaseIntensity {
  std::vector<TipAtEnd> tips;
  int unknowns = 0;
  double time = 0;             ///< at the end
  bool is_in_motion = false;   ///< dynamic; otherwise an equilibrium
  std::string failure;         ///< reason why the run did not reach its end; otherwise empty
  bool has_functions = false;  ///< the case requests near-tip functions
  int other_unknowns = 0;      ///< of the other treatment
  std::string no_other;        ///< reason for its absence; otherwise empty
};

/// Case that is ready for its first step, without crack growth.
struct IntensityPlan {
  GrowthCriterion criterion = GrowthCriterion::hoop_stress;  ///< direction of the kink
  ConfiguredCase made;
  Prepared prepared;
  Warnings warnings = {};  ///< of reading and of the preparation
};

/// Plans the case for `sif` and the library. The default profile is `standard`, also for files of Shi's programs,
/// whose rules know no tips. Throws InputError for a case without NMM bodies or without a tip in them, and as
/// `configured` and `prepared_case`.
IntensityPlan intensity_plan(const AskedCase& asked, const formats::Case& input);

/// Steps the case to its end, and evaluates the integrals there. If possible, repeats it with the other treatment of
/// tips. This is near-tip functions on sides of an eighth of the room around the narrowest tip, or no functions on
/// sides of 1/320 of it. Throws as `intensity_plan`.
CaseIntensity intensity_at_end(IntensityPlan plan);

}  // namespace keyblock::study
