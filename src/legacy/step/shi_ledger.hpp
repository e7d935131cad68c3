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

/// Momentum is taken about the mean of the centroids.
LedgerScope stored_scope(const StartPlaces& unloaded);

}  // namespace keyblock
