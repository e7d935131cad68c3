// One accepted step of the old program, told in order.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "contact/contact.hpp"
#include "contact/rules.hpp"
#include "model/settings.hpp"
#include "model/state.hpp"
#include "result/step_report.hpp"
#include "step/step_size.hpp"
#include "system/solve.hpp"
#include "terms/assemble.hpp"

namespace keyblock {

/// The fixed parts of a run's steps: what is computed on, and by which choices.
struct Scene {
  Model model;
  Settings settings;
  AnalysisDialect dialect = AnalysisDialect::berkeley;
  ContactRules rules;
  std::vector<Term> terms;
  bool has_contact = true;
};

Scene scene_of(Model model, Settings settings, AnalysisDialect dialect);

/// Everything that one step hands on to the next.
struct Stepping {
  State state;
  Contacts contacts;
  StepHistory history;
  double penalty = 0;  ///< contact stiffness to begin the next step with
  Solver solver;
  bool has_solved = false;
};

Stepping start(const Scene& scene);

/// A step that could not be made: the state is that of the last accepted step.
struct StepFailure {
  std::string reason;                 ///< one sentence
  std::vector<std::size_t> contacts;  ///< numbers (from 0) of the contacts that would not settle
};

/// Makes one step. On success `stepping` stands at its end; on failure its state is unchanged.
std::variant<StepReport, StepFailure> advance(const Scene& scene, Stepping& stepping);

}  // namespace keyblock
