// Contact springs and friction of the current states, through the bases of the two elements, into the system.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/contact.hpp"
#include "legacy/contact/rules.hpp"
#include "model/state.hpp"
#include "system/block_matrix.hpp"

namespace keyblock {

/// Normal spring of every closed contact and shear spring of every locked one, both measured on the geometry
/// at the start of the step (Shi 1988, contact submatrices; legacy-rules 8). `penalty` is the normal
/// stiffness, force / length.
void add_springs(const Contacts& contacts, const Model& model, const State& state, const ContactRules& rules,
                 double penalty, System& system);

/// With the friction and cohesion of every sliding contact for which `acts` is set, from the last judgement's pressure
/// and sliding direction (legacy-rules 9), and none of the others. `acts` has one entry a contact.
Contacts with_friction(Contacts contacts, const std::vector<bool>& acts, const Model& model);

void add_friction(const Contacts& contacts, const Model& model, const State& state, System& system);

}  // namespace keyblock
