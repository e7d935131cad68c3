// The state as members to save and restore.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/archive.hpp"
#include "model/state.hpp"

namespace keyblock {

/// Restored into a state of the same model, whose tables give the sizes; another size throws InputError.
void describe(Archive& archive, State& state);

/// Unknowns of one element, of its own number.
void describe(Archive& archive, const char* name, Unknowns& unknowns);

}  // namespace keyblock
