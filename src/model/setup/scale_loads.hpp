// All loads of bodies on covers multiplied by one factor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"

namespace keyblock {

/// Weight, body force, tractions, prescribed displacements and forces at points times `factor`; initial stress stays.
Continuum with_loads(Continuum continuum, double factor);

}  // namespace keyblock
