// The stored energies of a scene under the old program's step; what is lost it does not say.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/state.hpp"
#include "result/ledger.hpp"

namespace keyblock {

/// Kinetic, strain and gravity energy and momentum at `state`; its contact springs are not kept between steps, and its
/// rules lose and make energy that no term names: flows and impulse stay zero. `unloaded` is the state before the first
/// step.
LedgerRow stored_row(const Model& model, const Settings& settings, const State& state, const StartPlaces& unloaded);

/// Work that loads, the body acceleration, points held at a displacement of their own and bolts did on the elements in
/// a step, with their forces at its end as the equations have them: what Shi's step adds to kinetic energy is the sum
/// of all such work (F·d = ½ M (v1² − v0²) for v1 = 2d/dt − v0). Points held where they lie can only give back what
/// they took, and are left out.
double work_of_step(const Model& model, const Settings& settings, const State& before, const State& after);
/// Whether there is anything that does such work.
bool does_work(const Model& model, const Settings& settings);

/// Momentum is taken about the mean of the centroids.
LedgerScope stored_scope(const StartPlaces& unloaded);

}  // namespace keyblock
