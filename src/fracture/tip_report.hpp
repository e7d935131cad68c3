// The stress intensity of a tip by every choice of domain, how far these are apart, and which stands for it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fracture/tip_integrals.hpp"

namespace keyblock {

/// What one domain says, or why it is refused.
struct DomainResult {
  DomainChoice choice;
  std::optional<TipFactors> factors;
  std::string refusal = {};
};

struct TipReport {
  CrackTip tip;
  PlaneElasticity rock;
  double side = 0;             ///< of the triangle that holds the tip: the longest
  bool has_functions = false;  ///< near-tip functions on its covers
  std::vector<DomainResult> domains;
  /// Of the largest circle that is not refused; none where all are.
  std::optional<TipFactors> factors = {};
  /// Greatest less least of the circles, over |K| of `factors`.
  double spread_1 = 0;
  double spread_2 = 0;
};

/// The choices about a tip: circles out to shares of the room that it has, and 1, 2, 3, 4 and 6 levels.
std::vector<DomainChoice> domain_choices(const CrackTip& tip);

TipReport tip_report(const CoverSolution& solution, const CrackTip& tip);

/// Why the factors of a tip cannot be trusted, in words; empty where nothing speaks against them.
std::string doubt_of(const TipReport& report);

/// Why the mesh at a tip is too coarse for its factors, in words; empty where it is not.
std::string coarse_mesh_at(const Continuum& continuum, const CrackTip& tip);

/// By the largest circle alone; none where not even that has room.
std::optional<TipFactors> tip_factors(const CoverSolution& solution, const CrackTip& tip);

}  // namespace keyblock
