// Assembles contact springs and friction of the current states into the system, through the bases of the two elements.
// Theory: docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/contact.hpp"
#include "legacy/contact/rules.hpp"
#include "model/state.hpp"
#include "system/block_matrix.hpp"

namespace keyblock {

/// Adds the normal spring of every closed contact and the shear spring of every locked one. Both are measured on the
/// initial geometry of the step (Shi 1988, contact submatrices; legacy-rules 8). `penalty`: normal stiffness, force /
/// length.
void add_springs(const Contacts& contacts, const Model& model, const State& state, const ContactRules& rules,
                 double penalty, System& system);

/// Returns the contacts with friction and cohesion where `acts` is set, without them elsewhere. They follow from the
/// pressure and sliding direction of the last judgement (legacy-rules 9). `acts` has one entry per contact.
Contacts with_friction(Contacts contacts, const std::vector<bool>& acts, const Model& model);

void add_friction(const Contacts& contacts, const Model& model, const State& state, System& system);

}  // namespace keyblock
