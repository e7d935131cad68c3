// Selects the terms that a scene needs and assembles them in the order of the theory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "legacy/terms/term.hpp"
#include "model/setup/requirements.hpp"

namespace keyblock {

/// Returns the terms for these requirements. Contact is not among them, because it changes within a step.
std::vector<Term> terms_for(const Requirements& requirements);

/// Assembles all terms of a step except contact, with room for coupling between `coupled` elements.
System assemble(const std::vector<Term>& terms, const StepContext& context, const BlockMatrix::Pairs& coupled = {});

}  // namespace keyblock
