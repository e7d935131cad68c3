// Blocks and bodies on covers in one model.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"

namespace keyblock {

/// The elements of `bodies` behind those of `blocks`, all numbers moved on; materials are those of `blocks`. Points and
/// bolts of `blocks` come first, then those of `bodies`.
Model joined(Model blocks, const Model& bodies);

}  // namespace keyblock
