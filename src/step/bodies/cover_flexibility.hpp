// How bodies on covers answer forces on their unknowns: by their mass, and in a step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "contact/rows/contact_row.hpp"
#include "step/bodies/cover_equations.hpp"

namespace keyblock {

/// M⁻¹, body by body. Throws NotPositiveDefinite where covers carry no mass. The bodies must outlive it.
std::shared_ptr<const SharedFlexibility> mass_flexibility_of(const ElasticBodies& bodies);

/// A⁻¹ of the last factor of the equations, which must outlive it.
std::shared_ptr<const SharedFlexibility> flexibility_of(const CoverEquations& equations);

}  // namespace keyblock
