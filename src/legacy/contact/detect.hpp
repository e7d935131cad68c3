// Which vertices may touch which edges or vertices: first by distance, then by angle.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/contact.hpp"
#include "legacy/contact/rules.hpp"
#include "model/state.hpp"

namespace keyblock {

/// A new list, all open, from the geometry as it is now.
struct Detection {
  Contacts contacts;
  /// All contacts, if any, came from parallel pairs whose two halves were exchanged (legacy-rules 3, stale
  /// list).
  bool all_exchanged = true;
};

/// Legacy-rules 2 and 3 (Shi's angle criterion: two wedges that would overlap by more than h1 cannot touch
/// there).
Detection detect(const Model& model, const State& state, const Settings& settings, const ContactRules& rules);

}  // namespace keyblock
