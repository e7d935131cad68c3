// Computes the mass matrix of an element over its own unknowns.
// Theory: docs/theory/02-equations-of-motion.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/simplex.hpp"
#include "model/basis.hpp"

namespace keyblock {

/// Returns ∫ ρ TᵀT over the element, n × n; moments about the centroid, constant density (legacy-rules 7).
UnknownBlock mass_matrix(const Basis& basis, const Moments& moments, double density);

}  // namespace keyblock
