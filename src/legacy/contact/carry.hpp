// What last step's contacts hand on to this step's: states, sliding, bonds; and what a contact starts with.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/contact.hpp"
#include "legacy/contact/rules.hpp"
#include "model/state.hpp"

namespace keyblock {

/// Gives each new contact the state of the old one on the same triple (legacy-rules 4), then sets ratio and
/// length (5). `previous` holds the contacts as the last step left them; `contacts` are new and open.
Contacts carry(Contacts contacts, const Contacts& previous, const State& state, const ContactRules& rules,
               const BerkeleyQuirks& quirks);

/// Step 1 of a dynamic run: near contacts start closed, vertex-edge ones locked; contacts along an edge are
/// bonded (5, 6).
Contacts start_closed(Contacts contacts, const State& state, const ContactRules& rules);

/// Step 1 of a static run: all start open; contacts along an edge are bonded (5, 6).
Contacts start_open(Contacts contacts);

}  // namespace keyblock
