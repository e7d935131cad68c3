// Describes the state as members to save and restore.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/archive.hpp"
#include "model/state.hpp"

namespace keyblock {

/// Saves or restores a state. A restored state must belong to the same model, whose tables give the sizes; another size
/// throws InputError.
void describe(Archive& archive, State& state);

/// Saves or restores the unknowns of one element, whose number it stores.
void describe(Archive& archive, const char* name, Unknowns& unknowns);

}  // namespace keyblock
