// Implements Newton's method, the iteration of every search for a balance of forces, in dynamics and statics. Theory:
// docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "base/context.hpp"
#include "step/newton/tolerances.hpp"

namespace keyblock {

/// State of the iteration. All but the first two are reasons to cut: a shorter step or a smaller load increment may
/// help.
enum class RoundsEnd {
  open,               ///< forces are out of balance
  balanced,           ///< forces are in balance
  too_many_rounds,    ///< too many iterations, or several without progress
  not_finite,         ///< forces are not finite: an element has no area, or a law found no stress
  no_factor,          ///< the tangent has no inverse
  off_path,           ///< no load fraction lies at the required distance
  no_contact_forces,  ///< no forces of contacts, bolts and fixed points fit
  turned_over,        ///< balanced, but an element is turned inside out
};

/// Returns a phrase such as "too many rounds".
std::string_view in_words(RoundsEnd end);

/// Record of the iterations. `residuals`: before each iteration and at the end, over the largest force.
struct NewtonRounds {
  std::vector<double> residuals;
  RoundsEnd end = RoundsEnd::open;

  int count() const { return residuals.empty() ? 0 : static_cast<int>(residuals.size()) - 1; }
};

/// Iterates until the equations report an end. `state` judges the estimate, and `find_increment` finds the increment of
/// Newton's method, with contact forces if there are any. `search` chooses the part of it to take: WholeIncrements,
/// Backtracking or PartsByChange. The equations know what controls the search: a load fraction, which also moves driven
/// edges, or a length along the path of equilibria.
template <class Equations, class Search>
RoundsEnd newton(Equations& equations, Search& search, int most_rounds) {
  for (int round = 0;; ++round) {
    if (const RoundsEnd now = equations.state(); now != RoundsEnd::open) return now;
    leave_if_stopped();
    if (round == most_rounds) return RoundsEnd::too_many_rounds;
    if (const RoundsEnd found = equations.find_increment(round); found != RoundsEnd::open) return found;
    search.take_part(equations);
  }
}

/// Takes whole increments.
struct WholeIncrements {
  template <class Equations>
  void take_part(Equations& equations) const {
    equations.take(1);
  }
};

/// Halves an increment until the residual falls by a fraction of the predicted reduction (Armijo 1966).
struct Backtracking {
  template <class Equations>
  void take_part(Equations& equations) const {
    using tolerances::of_line_search::kLeastFall, tolerances::of_line_search::kMostHalvings;
    const double before = equations.residual();
    double part = 1;
    double after = equations.residual_with(part);
    for (int i = 0; i < kMostHalvings && !(after <= (1 - kLeastFall * part) * before); ++i) {
      if (equations.would_balance()) break;
      part /= 2;
      after = equations.residual_with(part);
    }
    equations.take(part);
  }
};

/// Takes smaller parts if points of elastoplastic rock alternate between the sides of their yield surface, which would
/// not end. The part is halved if the estimate changes about as much as in the last iteration. It is doubled after an
/// iteration that reduced the change much, or after two that reduced it as predicted. Residuals cannot guide this
/// search, because those of such iterations reflect contact gaps.
class PartsByChange {
 public:
  template <class Equations>
  void take_part(Equations& equations) {
    equations.take(equations.has_kinks() ? next(equations.change_over_last()) : 1);
  }

 private:
  double next(double left);

  double part_ = 1;
  int kept_ = 0;  ///< iterations in a row with the predicted reduction
};

}  // namespace keyblock
