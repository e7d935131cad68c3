// Decides the new states of all contacts after a solve. Theory: docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "legacy/contact/contact.hpp"
#include "legacy/contact/rules.hpp"
#include "model/state.hpp"

namespace keyblock {

/// Increments of all unknowns, element by element.
using Increments = Table<ElementIndex, Unknowns>;

/// Judges every contact by the linear displacement T D on the initial geometry of the step (Shi 1988, open-close rules;
/// legacy-rules 10). `penalty`: normal stiffness of the solve, force / length.
Contacts judge(Contacts contacts, const Model& model, const State& state, const Increments& increments,
               const ContactRules& rules, double penalty);

/// Returns the numbers of contacts that changed between open and closed in the last judgement.
std::vector<std::size_t> changed(const Contacts& contacts);

}  // namespace keyblock
