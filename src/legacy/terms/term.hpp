// Declares the input of every physical term: the scene, its state and the next step. A term adds to the system and
// knows no other term.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/state.hpp"
#include "settings/settings.hpp"
#include "system/block_matrix.hpp"

namespace keyblock {

struct StepContext {
  const Model& model;
  const State& state;
  const Settings& settings;
  double dt;
};

using Term = void (*)(const StepContext& context, System& system);

}  // namespace keyblock
