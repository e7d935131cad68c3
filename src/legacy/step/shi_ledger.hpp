// Computes the stored energies of a scene under Shi's rules. Losses are not known.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/state.hpp"
#include "result/ledger.hpp"

namespace keyblock {

/// Returns kinetic, strain and gravity energy and momentum at `state`. Contact springs are not kept between steps, and
/// the rules lose and create energy that no term names: flows and impulse are zero. `unloaded`: state before the first
/// step.
LedgerRow stored_row(const Model& model, const Settings& settings, const State& state, const StartPlaces& unloaded);

/// Returns the work on the elements in a step by loads, body acceleration, driven points and bolts. Their forces are
/// those at the end of the step, as in the equations. Shi's step adds exactly the sum of all such work to the kinetic
/// energy (F·d = ½ M (v1² − v0²) for v1 = 2d/dt − v0). Points fixed in place can only return energy that they took, and
/// are left out.
double work_of_step(const Model& model, const Settings& settings, const State& before, const State& after);
/// Returns true if anything does such work.
bool does_work(const Model& model, const Settings& settings);

/// Returns the scope of the energy balance; momentum is taken about the mean of the centroids.
LedgerScope stored_scope(const StartPlaces& unloaded);

}  // namespace keyblock
