// New states of all contacts after a solve.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "legacy/contact/contact.hpp"
#include "legacy/contact/rules.hpp"
#include "model/state.hpp"

namespace keyblock {

/// The increments of all unknowns, element by element.
using Increments = Table<ElementIndex, Unknowns>;

/// Judges every contact by the linear displacement T D on the geometry at the start of the step (Shi 1988,
/// open-close rules; legacy-rules 10). `penalty` is the normal stiffness of the solve, force / length.
Contacts judge(Contacts contacts, const Model& model, const State& state, const Increments& increments,
               const ContactRules& rules, double penalty);

/// Numbers of the contacts that changed between open and closed in the last judgement.
std::vector<std::size_t> changed(const Contacts& contacts);

}  // namespace keyblock
