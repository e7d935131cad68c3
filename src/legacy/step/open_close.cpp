// Repeats passes of the open–close iteration on the system of the step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/open_close.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/context.hpp"
#include "legacy/contact/springs.hpp"
#include "legacy/step/cover_unknowns.hpp"

namespace keyblock {
namespace {

// A contact that has just closed has no friction yet. In the first pass of a step friction is that of the last step.
std::vector<bool> friction_acts(const Contacts& contacts, Attempt attempt, int pass) {
  std::vector<bool> acts;
  for (const Contact& contact : contacts) {
    const bool first_pass = pass == 1;
    acts.push_back(first_pass ? attempt != Attempt::redone : contact.state_before != ContactState::open);
  }
  return acts;
}

// Returns the mean of p Δt² / 2m over the blocks. Without contact the first entry of a block is 2m/Δt², more if it is
// fixed.
double stiffness_over_inertia(const BlockMatrix& matrix, double penalty) {
  double sum = 0;
  for (int i = 0; i < matrix.block_count(); ++i) sum += penalty / matrix.row(i).front().block(0, 0);
  return sum / std::max(1, matrix.block_count());
}

}  // namespace

OpenCloseOutcome open_close(const System& without_contact, Contacts contacts, const Model& model, const State& state,
                            const Settings& settings, const ContactRules& rules, double penalty, double dt,
                            Attempt attempt, Solver& solver) {
  OpenCloseOutcome outcome;
  outcome.contacts = std::move(contacts);
  const CoverUnknowns covers(model, state);
  SystemKind kind{stiffness_over_inertia(without_contact.matrix, penalty), covers.steady(state, dt)};
  const int bound = settings.quirks.fixed_pass_bound ? kBerkeleyPassBound : settings.pass_limit;
  System system({});  // keeps its memory from pass to pass
  while (outcome.passes < bound) {
    leave_if_stopped();
    ++outcome.passes;
    system = without_contact;
    add_springs(outcome.contacts, model, state, rules, penalty, system);
    const std::vector<bool> acts = friction_acts(outcome.contacts, attempt, outcome.passes);
    outcome.contacts = with_friction(std::move(outcome.contacts), acts, model);
    add_friction(outcome.contacts, model, state, system);
    const std::optional<Solution> solution = covers.solve(system, kind, solver);
    if (!solution) {
      outcome.failure = {"system_not_solved"};
      return outcome;
    }
    outcome.residual = std::max(outcome.residual, solution->residual);
    if (outcome.residual > kUselessResidual) {
      outcome.failure = {"solution_out_of_balance", {{{"residual", outcome.residual}}}};
      return outcome;
    }
    outcome.increments = covers.increments(*solution);
    outcome.node_steps = covers.node_steps(*solution);
    kind.guess = solution->x;
    outcome.contacts = judge(std::move(outcome.contacts), model, state, outcome.increments, rules, penalty);
    outcome.still_changing = changed(outcome.contacts);
    const bool must_repeat = attempt == Attempt::first_of_run && outcome.passes == 1;
    if (outcome.still_changing.empty() && !must_repeat) break;
  }
  return outcome;
}

}  // namespace keyblock
