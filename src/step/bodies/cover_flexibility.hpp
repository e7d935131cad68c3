// Declares the response of NMM bodies to forces on their unknowns: by their mass, and within a step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "contact/rows/contact_row.hpp"
#include "step/bodies/cover_equations.hpp"

namespace keyblock {

/// Returns M⁻¹, body by body. Throws NotPositiveDefinite if covers have no mass. The bodies must outlive the result.
std::shared_ptr<const SharedFlexibility> mass_flexibility_of(const ElasticBodies& bodies);

/// Returns A⁻¹ of the last factorisation of the equations, which must outlive the result.
std::shared_ptr<const SharedFlexibility> flexibility_of(const CoverEquations& equations);

}  // namespace keyblock
