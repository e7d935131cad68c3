// Finds vertices that may touch edges or vertices: first by distance, then by angle. Theory:
// docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/contact.hpp"
#include "legacy/contact/near_vertices.hpp"
#include "legacy/contact/rules.hpp"
#include "model/state.hpp"

namespace keyblock {

/// New list of contacts, all open, from the current geometry.
struct Detection {
  Contacts contacts;
  /// True if all contacts, if any, came from parallel pairs with exchanged halves (legacy-rules 3, stale list).
  bool all_exchanged = true;
};

/// Detects contacts by legacy-rules 2 and 3. Shi's angle criterion: two wedges that would overlap by more than h1
/// cannot touch there. `near` is the list of this model from the steps before.
Detection detect(const Model& model, const State& state, const Settings& settings, const ContactRules& rules,
                 NearVertices& near);

/// Does the same with a new search.
inline Detection detect(const Model& model, const State& state, const Settings& settings, const ContactRules& rules) {
  NearVertices near;
  return detect(model, state, settings, rules, near);
}

}  // namespace keyblock
