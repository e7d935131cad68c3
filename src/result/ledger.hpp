// The energy and momentum of a run, step by step: what is stored, what was done and lost since the start.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

/// Energy at an instant, per unit thickness.
struct StoredEnergy {
  double kinetic = 0;
  double strain = 0;
  double gravity = 0;  ///< potential of the weights, 0 where the unloaded blocks lie
  double contact = 0;  ///< in contact springs and bolts

  double total() const { return kinetic + strain + gravity + contact; }
};

/// Energy that came and went, per unit thickness. The losses are ≥ 0 but for what their lines say.
struct EnergyFlow {
  // Gains.
  double external = 0;    ///< work of all loads but weight
  double projection = 0;  ///< work against gravity of setting blocks that met to where the jump would have left them
  double geometric = 0;  ///< normal forces along mid-step rows for the true gaps: either sign, second order in the step
  double creep = 0;  ///< sticking points over the slip that their law lets pass: either sign, first order in the step
  double change =
      0;  ///< what changes of the scene brought with them; negative where rock was taken away with its energy
  // Losses.
  double friction = 0;
  double damping = 0;  ///< of the damping matrix, and velocity that is not carried over
  double impact = 0;   ///< in jumps of velocity, friction included
  double closing = 0;  ///< normal forces times the gaps they closed; negative where they pushed an overlap apart
  double clean_up = 0;
  double rupture = 0;      ///< what bolts held that broke
  double fracture = 0;     ///< of new faces of cracks, which let go of each other
  double plastic = 0;      ///< stress at the end of steps times the plastic strain of rock that yields
  double algorithmic = 0;  ///< of the integrator and of its rule for contact springs

  double gained() const { return external + projection + geometric + creep + change; }
  double lost() const {
    return friction + damping + impact + closing + clean_up + rupture + fracture + plastic + algorithmic;
  }
  EnergyFlow& operator+=(const EnergyFlow& other);
};

/// Linear momentum and that about the `centre` of the ledger.
struct Momentum {
  Point linear;
  double angular = 0;

  Momentum& operator+=(const Momentum& other);
};

/// Sums of |p|, and of |p| times arm and block size and of spins: they do not cancel.
struct MomentumSize {
  double linear = 0;
  double angular = 0;
};

/// The energy ledger at the end of a step; row 0 is the start.
struct LedgerRow {
  int step = 0;
  double time = 0;
  StoredEnergy stored;
  EnergyFlow flow;  ///< since the start
  Momentum momentum;
  Momentum impulse;  ///< of all loads, weight included, since the start, and what changes of the scene took away or
                     ///< brought; supports are not in it
  MomentumSize momentum_size;
};

/// Which balances the rows are meant to close.
struct LedgerScope {
  bool has_flows = false;    ///< energy: false where stored energies alone are kept
  bool has_supports = true;  ///< momentum: true where held blocks push too
  Point centre;              ///< that angular momentum is taken about
  bool has_changes = false;  ///< the scene changes during the run
  bool may_yield = false;    ///< some of its rock may yield
  bool may_crack = false;    ///< cracks may go on in it
  bool has_work = false;     ///< without flows: the work of all that pushes but weight and contact is kept
};

struct Ledger {
  LedgerScope scope;
  std::vector<LedgerRow> rows;
};

/// How well rows close, told one after another.
struct LedgerSums {
  bool is_begun = false;
  LedgerRow first;
  double largest = 0;      ///< energy
  double energy_gap = 0;   ///< greatest |stored − stored at the start − gained + lost|
  double linear_gap = 0;   ///< greatest |momentum − that at the start − impulse|
  double linear_size = 0;  ///< largest sum of amounts
  double angular_gap = 0;  ///< as the linear ones
  double angular_size = 0;
  double largest_stored = 0;  ///< kinetic, strain, contact, or gravity since the start
  double least = 0;           ///< of what was stored less the work of loads, so far
  /// greatest kinetic, strain and gravity energy less the work of loads over the least before
  double made = 0;
  double above_start = 0;  ///< the same over that of the start

  void add(const LedgerRow& row);

  /// The largest stored energy, counted from the start where it is a potential, or flow.
  double largest_energy() const { return largest; }
  /// Gaps over what they are part of; 0 where nothing moves.
  double energy_closure() const;
  double linear_momentum_closure() const;
  double angular_momentum_closure() const;
  /// Energy that nothing gave, over the largest stored: what moves, strains and lies high is more than all there was at
  /// some instant before. What contact springs hold counts where it may come from, not where it goes to: it is not
  /// there until they give it back. Without flows, where contact is not in the books, more than at the start.
  double energy_made(const LedgerScope& scope) const;
};

/// The same of a whole ledger.
LedgerSums sums_of(const Ledger& ledger);

}  // namespace keyblock
