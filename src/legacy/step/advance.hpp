// One accepted step of the old program, told in order.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "legacy/contact/contact.hpp"
#include "legacy/contact/rules.hpp"
#include "legacy/terms/assemble.hpp"
#include "model/scene/scene.hpp"
#include "model/state.hpp"
#include "settings/settings.hpp"
#include "step/stepper.hpp"
#include "step/time/step_size.hpp"
#include "system/solve.hpp"

namespace keyblock {

/// A scene with what Shi's rules derive from it once.
struct ShiScene : Scene {
  ContactRules rules;
  std::vector<Term> terms;
  bool has_contact = true;
};

ShiScene shi_scene(Scene scene);

/// Everything that one step hands on to the next.
struct Stepping {
  State state;
  Contacts contacts;
  StepHistory history;
  double penalty = 0;  ///< contact stiffness to begin the next step with
  Solver solver;
  bool has_solved = false;
  double work = 0;  ///< of all that pushes but weight and contact, since the start
};

Stepping start(const ShiScene& scene);

/// Makes one step. On success `stepping` stands at its end; on failure its state is unchanged.
std::variant<StepReport, StepFailure> advance(const ShiScene& scene, Stepping& stepping);

}  // namespace keyblock
