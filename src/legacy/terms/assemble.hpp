// The terms a scene needs, called in the order of the theory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "legacy/terms/term.hpp"
#include "model/setup/requirements.hpp"

namespace keyblock {

/// The terms to call for these requirements; contact is not among them, it changes within a step.
std::vector<Term> terms_for(const Requirements& requirements);

/// Everything of one step except contact; with room for what couples `coupled` elements.
System assemble(const std::vector<Term>& terms, const StepContext& context, const BlockMatrix::Pairs& coupled = {});

}  // namespace keyblock
