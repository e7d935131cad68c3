// Records the steps of a run: sums over all, and a bounded number of rows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "result/ledger.hpp"
#include "result/step_report.hpp"
#include "result/rows/thinned.hpp"

namespace keyblock {

/// Residual above which the forces of a step count as unbalanced: under `standard` a share of the largest load. The
/// solver finds forces to 1e-6 and better.
inline constexpr double kUnbalanced = 1e-4;

/// Sums over all steps added so far.
struct StepTotals {
  int steps = 0;
  int most_contacts = 0;
  int redos = 0;
  int fallbacks = 0;
  std::size_t passes = 0;
  int most_passes = 0;
  /// Largest number of open–close iterations in each bin of the histogram; steps in the last bin have more.
  static constexpr std::array<int, 4> pass_limits{0, 3, 10, 40};
  std::array<int, pass_limits.size() + 1> steps_by_passes{};
  int unresolved_parts = 0;
  int locked_overlaps = 0;
  double greatest_penetration = 0;
  double penetration_share = 0;
  double area_share = 1;
  int crushed_element = 0;  ///< number of the element that had it
  double greatest_displacement_ratio = 0;
  double greatest_residual = 0;
  int unbalanced_steps = 0;  ///< with a residual above `kUnbalanced`
  double least_dt = std::numeric_limits<double>::max();
  double greatest_dt = 0;

  void add(const StepReport& step);
};

/// Extreme values of a step; the steps with the worst of them are kept.
struct StepExtremes {
  using Value = double (*)(const StepReport&);
  static constexpr std::array<Value, 8> values{[](const StepReport& s) { return -s.dt; },
                                               [](const StepReport& s) { return double(s.passes); },
                                               [](const StepReport& s) { return double(s.redos); },
                                               [](const StepReport& s) { return double(s.fallbacks); },
                                               [](const StepReport& s) { return double(s.contacts); },
                                               [](const StepReport& s) { return s.greatest_penetration; },
                                               [](const StepReport& s) { return s.displacement_ratio; },
                                               [](const StepReport& s) { return s.residual; }};
};

struct LedgerExtremes {
  using Value = double (*)(const LedgerRow&);
  static constexpr std::array<Value, 3> values{[](const LedgerRow& r) { return r.stored.kinetic; },
                                               [](const LedgerRow& r) { return r.stored.strain; },
                                               [](const LedgerRow& r) { return r.stored.contact; }};
};

using StepRows = Thinned<StepReport, StepExtremes>;
using LedgerRows = Thinned<LedgerRow, LedgerExtremes>;

}  // namespace keyblock
