// Reports the stress intensity of a tip by every choice of domain, the spread of these, and the value that represents
// them. Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fracture/tip_integrals.hpp"

namespace keyblock {

/// Factors from one domain, or the reason for its refusal.
struct DomainResult {
  DomainChoice choice;
  std::optional<TipFactors> factors;
  std::string refusal = {};
};

struct TipReport {
  CrackTip tip;
  PlaneElasticity rock;
  double side = 0;             ///< longest side of the triangle that holds the tip
  bool has_functions = false;  ///< near-tip functions on its covers
  std::vector<DomainResult> domains;
  /// Factors from the largest circle that is not refused; none if all are refused.
  std::optional<TipFactors> factors = {};
  /// Greatest minus least value of the circles, over |K| of `factors`.
  double spread_1 = 0;
  double spread_2 = 0;
};

/// Returns the choices at a tip: circles out to shares of its room, and 1, 2, 3, 4 and 6 levels.
std::vector<DomainChoice> domain_choices(const CrackTip& tip);

TipReport tip_report(const CoverSolution& solution, const CrackTip& tip);

/// Returns the reason why the factors of a tip cannot be trusted, in words; empty without one.
std::string doubt_of(const TipReport& report);

/// Returns the reason why the mesh at a tip is too coarse for its factors, in words; empty if it is fine enough.
std::string coarse_mesh_at(const Continuum& continuum, const CrackTip& tip);

/// Returns the factors from the largest circle alone; none if even that has no room.
std::optional<TipFactors> tip_factors(const CoverSolution& solution, const CrackTip& tip);

}  // namespace keyblock
