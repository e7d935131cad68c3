// Transfers states, sliding and bonds from the contacts of the last step to those of the next, and sets initial states.
// Theory: docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/contact.hpp"
#include "legacy/contact/rules.hpp"
#include "model/state.hpp"

namespace keyblock {

/// Gives each new contact the state of the old one on the same triple (legacy-rules 4), then sets ratio and length (5).
/// `previous`: contacts as the last step left them. `contacts`: new and open.
Contacts carry(Contacts contacts, const Contacts& previous, const State& state, const ContactRules& rules,
               const BerkeleyQuirks& quirks);

/// Sets the states of step 1 of a dynamic run. Near contacts start closed, vertex-edge ones locked; contacts along an
/// edge are bonded (5, 6).
Contacts start_closed(Contacts contacts, const State& state, const ContactRules& rules);

/// Sets the states of step 1 of a static run: all start open; contacts along an edge are bonded (5, 6).
Contacts start_open(Contacts contacts);

}  // namespace keyblock
