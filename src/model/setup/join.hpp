// Joins DDA blocks and NMM bodies in one model.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"

namespace keyblock {

/// Appends the elements of `bodies` to those of `blocks` and shifts all their numbers; materials are those of `blocks`.
/// Points and bolts of `blocks` come first, then those of `bodies`.
Model joined(Model blocks, const Model& bodies);

}  // namespace keyblock
