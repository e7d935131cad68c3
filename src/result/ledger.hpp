// Holds the energy balance and the momentum of a run, step by step: stored energy, work and losses since the start.
// Theory: docs/theory/12-energy-balance.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

/// Energy at an instant, per unit thickness.
struct StoredEnergy {
  double kinetic = 0;
  double strain = 0;
  double gravity = 0;  ///< potential of the weights, 0 for the unloaded blocks
  double contact = 0;  ///< in contact springs and bolts

  double total() const { return kinetic + strain + gravity + contact; }
};

/// Energy gained and lost, per unit thickness. Losses are ≥ 0, except as their lines state.
struct EnergyFlow {
  // Gains.
  double external = 0;    ///< work of all loads except weight
  double projection = 0;  ///< work against gravity of setting blocks after an impact to where the jump leaves them
  double geometric = 0;   ///< normal forces at mid-step rows, not at true gaps: either sign, second order in the step
  double creep = 0;  ///< sticking points over the slip that their law permits: either sign, first order in the step
  double change =
      0;  ///< energy brought in by changes of the scene; negative if rock was removed together with the energy in it
  // Losses.
  double friction = 0;
  double damping = 0;  ///< of the damping matrix, and of velocity that is not carried over
  double impact = 0;   ///< in jumps of velocity, friction included
  double closing = 0;  ///< normal forces times the gaps they closed; negative if they pushed an overlap apart
  double clean_up = 0;
  double rupture = 0;      ///< stored in bolts that broke
  double fracture = 0;     ///< of new faces of cracks as they separate
  double plastic = 0;      ///< stress at the end of steps times plastic strain
  double algorithmic = 0;  ///< of the integrator and of its rule for contact springs

  double gained() const { return external + projection + geometric + creep + change; }
  double lost() const {
    return friction + damping + impact + closing + clean_up + rupture + fracture + plastic + algorithmic;
  }
  EnergyFlow& operator+=(const EnergyFlow& other);
};

/// Linear momentum, and angular momentum about the `centre` of the balance.
struct Momentum {
  Point linear;
  double angular = 0;

  Momentum& operator+=(const Momentum& other);
};

/// Sums of |p|, and of |p| times arm and block size and of spins, which do not cancel.
struct MomentumSize {
  double linear = 0;
  double angular = 0;
};

/// Energy balance at the end of a step; row 0 is the start.
struct LedgerRow {
  int step = 0;
  double time = 0;
  StoredEnergy stored;
  EnergyFlow flow;  ///< since the start
  Momentum momentum;
  Momentum impulse;  ///< of all loads since the start, weight included, and of changes of the scene; supports are not
                     ///< included
  MomentumSize momentum_size;
};

/// Balances that the rows should close.
struct LedgerScope {
  bool has_flows = false;    ///< energy: false if only stored energies are recorded
  bool has_supports = true;  ///< momentum: true if fixed blocks push too
  Point centre;              ///< for the angular momentum
  bool has_changes = false;  ///< the scene changes during the run
  bool may_yield = false;    ///< some of its rock may yield
  bool may_crack = false;    ///< cracks may propagate in it
  bool has_work = false;     ///< without flows: the work of all forces except weight and contact is recorded
};

struct Ledger {
  LedgerScope scope;
  std::vector<LedgerRow> rows;
};

/// Closure of rows that are added one after another.
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
  double least = 0;           ///< of stored energy minus the work of loads, so far
  /// greatest rise of kinetic, strain and gravity energy minus the work of loads above its least value before
  double made = 0;
  double above_start = 0;  ///< the same above the initial value

  void add(const LedgerRow& row);

  /// Returns the largest stored energy or flow; potentials count from the start.
  double largest_energy() const { return largest; }
  /// Return gaps relative to the largest quantity of their balance; 0 if nothing moves.
  double energy_closure() const;
  double linear_momentum_closure() const;
  double angular_momentum_closure() const;
  /// Returns the energy without a source, over the largest stored. It is the rise of kinetic, strain and gravity energy
  /// above all energy at an earlier instant. Energy in contact springs counts as a source, but is not a gain until they
  /// return it. Without flows, contact is not recorded, and the rise above the start counts.
  double energy_made(const LedgerScope& scope) const;
};

}  // namespace keyblock
