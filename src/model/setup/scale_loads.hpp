// Multiplies all loads of NMM bodies by one factor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"

namespace keyblock {

/// Multiplies weight, body force, tractions, prescribed displacements and point forces by `factor`; initial stress
/// stays.
Continuum with_loads(Continuum continuum, double factor);

}  // namespace keyblock
