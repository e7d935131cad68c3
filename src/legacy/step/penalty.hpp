// The contact stiffness from step to step.
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

/// Greatest penetration of the closed contacts over the size of the smaller element, that is the largest distance of
/// its vertices from its centroid; ≥ 0.
double penetration_share(const Contacts& contacts, const Model& model, const State& state);

/// The adapted stiffness, and whether penetration was so deep that the step must be redone with it
/// (legacy-rules 11.3).
struct AdaptedPenalty {
  double penalty = 0;
  bool redo = false;
};
AdaptedPenalty adapt(double penalty, const Misfit& misfit, double scale, const Settings& settings);

}  // namespace keyblock
