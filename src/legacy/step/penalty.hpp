// Adapts the contact stiffness from step to step. Theory: docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/contact.hpp"
#include "legacy/contact/rules.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Greatest opening and penetration of the closed contacts, lengths ≥ 0.
struct Misfit {
  double opening = 0;
  double penetration = 0;
};
Misfit misfit(const Contacts& contacts);

/// Returns the greatest penetration of the closed contacts over the size of the smaller element; ≥ 0. The size is the
/// largest distance of a vertex from the centroid.
double penetration_share(const Contacts& contacts, const Model& model, const State& state);

/// Adapted stiffness. `redo`: penetration was so deep that the step must be repeated with it (legacy-rules 11.3).
struct AdaptedPenalty {
  double penalty = 0;
  bool redo = false;
};
AdaptedPenalty adapt(double penalty, const Misfit& misfit, double scale, const Settings& settings);

}  // namespace keyblock
