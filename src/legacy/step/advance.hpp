// Performs one time step by Shi's rules, in the order of the Berkeley program. Theory: docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "legacy/contact/contact.hpp"
#include "legacy/contact/near_vertices.hpp"
#include "legacy/contact/rules.hpp"
#include "legacy/terms/assemble.hpp"
#include "model/scene/scene.hpp"
#include "model/state.hpp"
#include "settings/settings.hpp"
#include "step/stepper.hpp"
#include "step/time/step_size.hpp"
#include "system/solve.hpp"

namespace keyblock {

/// Scene with the data that Shi's rules derive from it once.
struct ShiScene : Scene {
  ContactRules rules;
  std::vector<Term> terms;
  bool has_contact = true;
};

ShiScene shi_scene(Scene scene);

/// Data passed from one step to the next.
struct Stepping {
  State state;
  Contacts contacts;
  StepHistory history;
  double penalty = 0;  ///< contact stiffness at the start of the next step
  Solver solver;
  NearVertices near;
  bool has_solved = false;
  double work = 0;  ///< of all forces except weight and contact, since the start
};

Stepping start(const ShiScene& scene);

/// Makes one step. On success `stepping` is at its end; on failure its state is unchanged.
std::variant<StepReport, StepFailure> advance(const ShiScene& scene, Stepping& stepping);

}  // namespace keyblock
