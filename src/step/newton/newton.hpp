// Newton's method: the rounds of every search of a step for a balance of forces, in time and at rest.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "base/context.hpp"
#include "step/newton/tolerances.hpp"

namespace keyblock {

/// How rounds stand. All but the first two are the names of cuts: a shorter step, or a part of the loads, is the
/// remedy.
enum class RoundsEnd {
  open,               ///< forces are out of balance
  balanced,           ///< they are not
  too_many_rounds,    ///< or fewer would do that lead nowhere
  not_finite,         ///< forces are not numbers: an area is none, or a law found no stress
  no_factor,          ///< the tangent has no inverse
  off_path,           ///< no share of the loads lies at the wanted distance
  no_contact_forces,  ///< contact, bolts and held points have no forces that fit
  turned_over,        ///< balanced, but an element is turned inside out
};

/// "too many rounds", and the like.
std::string_view in_words(RoundsEnd end);

/// What rounds took. `residuals`: before each round and at the end, over the largest of the forces.
struct NewtonRounds {
  std::vector<double> residuals;
  RoundsEnd end = RoundsEnd::open;

  int count() const { return residuals.empty() ? 0 : static_cast<int>(residuals.size()) - 1; }
};

/// The rounds. Equations say how their estimate stands (`state`), find what Newton's method adds to it, with contact
/// forces where there are any (`find_increment`), and take a part of that, which `search` chooses: WholeIncrements,
/// Backtracking or PartsByChange. What controls them, a share of the loads and of the ways of driven edges or a
/// length along the path of equilibria, is a matter of the equations.
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

/// Increments as they are.
struct WholeIncrements {
  template <class Equations>
  void take_part(Equations& equations) const {
    equations.take(1);
  }
};

/// An increment is halved while the residual does not fall by a share of what it promises (Armijo 1966).
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

/// Where rock may yield, points that change sides of their surface in turn would go on so: half as much of a round that
/// changes the estimate as much as the one before; twice as much after one that led far, or two that led as far as
/// their part promised. Residuals of such rounds are those of their gaps, and say nothing of the way.
class PartsByChange {
 public:
  template <class Equations>
  void take_part(Equations& equations) {
    equations.take(equations.has_kinks() ? next(equations.change_over_last()) : 1);
  }

 private:
  double next(double left);

  double part_ = 1;
  int kept_ = 0;  ///< rounds in a row that led as far as promised
};

}  // namespace keyblock
