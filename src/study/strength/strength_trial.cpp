// Settings of statics, steps until something fails, what is kept for pictures.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/strength/strength_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <utility>

#include "base/stop.hpp"
#include "run/record.hpp"
#include "run/settings_of.hpp"
#include "run/steppers.hpp"

namespace keyblock::study {
namespace {

// Parts in which the loads of a case of motion come on where its rock may yield.
constexpr int kLoadParts = 10;
// Halvings of a load step before a trial falls: the factor is bisected, not the load. Two of them take three times the
// rounds and leave the factors of legacy_cases/strength_reduction where they are.
constexpr int kLoadCuts = 0;

bool is_constant(const TimeCurve& curve) {
  return std::ranges::all_of(curve.values, [&](Point value) { return value == curve.values.front(); });
}

bool has_constant_loads(const Problem& problem, const Settings& settings) {
  const Analysis& analysis = *problem.analysis;
  return std::ranges::all_of(analysis.fixed_point_motions, is_constant) &&
         std::ranges::all_of(analysis.point_loads, is_constant) && is_constant(analysis.body_acceleration) &&
         is_constant(settings.body_acceleration.curve) && !problem.motion;
}

bool is_on_covers(const Problem& problem) {
  return problem.covers || std::holds_alternative<Cover>(problem.geometry);
}

double largest_displacement(const Stepper& stepper, const State& state) {
  double most = 0;
  for (const VertexIndex v : indices(stepper.model().vertices))
    most = std::max(most, length(state.vertices[v] - stepper.unloaded().vertices[v]));
  return most;
}

// Stress is that of the state before.
FieldFrame field_at(FieldFrame field, const Stepper& stepper, const State& state) {
  for (const ElementIndex e : indices(stepper.model().elements)) {
    FieldElement& out = field.elements[static_cast<std::size_t>(e.value)];
    out.middle.displacement = state.elements[e].centroid - out.middle.position;
    VertexIndex v = stepper.model().elements[e].first_vertex;
    for (auto& loop : out.loops)
      for (FieldCorner& corner : loop) {
        corner.displacement = state.vertices[v] - corner.position;
        ++v.value;
      }
  }
  return field;
}

StrengthState state_of(const Stepper& stepper) {
  StrengthState state{frame_of(stepper.model(), stepper.state(), stepper.unloaded(), stepper.settings()),
                      field_of(stepper.model(), stepper),
                      {}};
  for (const ElementIndex e : indices(stepper.model().elements)) {
    const std::optional<PlasticState> plastic = stepper.plastic_at(e, stepper.unloaded().elements[e].centroid);
    state.plastic_strains.push_back(plastic ? plastic->equivalent : 0);
  }
  return state;
}

/// Steps to the end of the scene, or to the first that fails.
TrialOutcome stepped(std::unique_ptr<Stepper> stepper, const std::function<bool()>& wants_stop) {
  TrialOutcome made;
  while (stepper->state().step < stepper->settings().step_count && !stepper->is_done()) {
    if (wants_stop()) throw StopRequested();
    const auto step = stepper->advance();
    if (const auto* report = std::get_if<StepReport>(&step)) {
      made.told.rounds += report->passes;
      continue;
    }
    const auto& failure = std::get<StepFailure>(step);
    made.told.rounds += failure.passes;
    made.told.verdict = is_of_the_scene(failure.kind) ? Verdict::falls : Verdict::undecided;
    made.told.why = failure.reason;
    made.rock_yields = failure.rock_yields;
    const std::optional<State> attempted = stepper->attempted();
    made.told.displacement = largest_displacement(*stepper, attempted ? *attempted : stepper->state());
    made.state = state_of(*stepper);
    if (attempted) made.attempt = field_at(made.state.field, *stepper, *attempted);
    return made;
  }
  made.told.verdict = Verdict::stands;
  made.told.is_balanced = true;
  made.told.displacement = largest_displacement(*stepper, stepper->state());
  made.state = state_of(*stepper);
  return made;
}

void put_setting(std::vector<Override>& overrides, const char* name, const std::string& value) {
  std::erase_if(overrides, [&](const Override& o) { return o.first == name; });
  overrides.emplace_back(name, value);
}

}  // namespace

std::string name_of(Verdict verdict) {
  constexpr std::array<const char*, 3> kNames{"stands", "falls", "undecided"};
  return kNames.at(static_cast<std::size_t>(verdict));
}

StrengthTrials::StrengthTrials(Problem problem, std::string profile, std::vector<Override> overrides, Reduced what)
    : problem_(std::move(problem)), profile_(std::move(profile)), overrides_(std::move(overrides)), what_(what) {
  require_strength(problem_, what_);
  if (problem_.analysis) {
    const Settings settings = settings_of(problem_, profile_, overrides_);
    if (settings.dynamics != Dynamics::standard)
      throw InputError(problem_.analysis->place,
                       "expected a profile with statics (standard, draft, reference), for strength is reduced there; "
                       "found the rules of the old programs");
    const bool is_in_time = settings.standard.motion == MotionRule::dynamic;
    if (is_in_time) {
      put_setting(overrides_, "motion", "static");
      notes_.emplace_back("the case is one of motion in time: its equilibrium under the same loads is sought");
    }
    if (is_in_time && problem_.stages.empty() && has_constant_loads(problem_, settings)) {
      const int steps = is_on_covers(problem_) ? std::min(settings.step_count, kLoadParts) : 1;
      put_setting(overrides_, "steps", fmt::format("{}", steps));
    }
  }
  prepared_ = prepared_at(1);
  if (what_ == Reduced::joints && prepared_.scene.is_untouched)
    throw InputError(problem_.analysis->place,
                     "expected bodies that touch, whose joints are to be reduced, found bodies on covers that do not "
                     "feel each other");
}

Prepared StrengthTrials::prepared_at(double factor) const {
  return prepare(with_reduced_strength(problem_, what_, factor), profile_, overrides_);
}

bool StrengthTrials::may_yield() const {
  return what_ != Reduced::joints &&
         std::ranges::any_of(problem_.analysis->block_materials,
                             [](const BlockMaterial& rock) { return rock.strength != nullptr; });
}

TrialOutcome StrengthTrials::run(double factor, const std::function<bool()>& wants_stop) const {
  Scene scene = prepared_at(factor).scene;
  scene.load_cuts = kLoadCuts;
  TrialOutcome made = stepped(stepper_for(scene), wants_stop);
  const bool is_first_try = scene.settings.standard.motion == MotionRule::equilibrium;
  if (made.told.verdict == Verdict::undecided && is_first_try && !scene.is_untouched) {
    scene.settings.standard.motion = MotionRule::relaxation;
    TrialOutcome again = stepped(stepper_for(std::move(scene)), wants_stop);
    again.told.rounds += made.told.rounds;
    if (again.told.verdict != Verdict::undecided) made = std::move(again);
  }
  // Of rock that yields no calculation shows more than that it finds no equilibrium. Where none does, it is contacts
  // that do not settle, and nothing is decided.
  if (made.told.verdict == Verdict::undecided && may_yield() && made.rock_yields) made.told.verdict = Verdict::falls;
  made.told.factor = factor;
  return made;
}

}  // namespace keyblock::study
