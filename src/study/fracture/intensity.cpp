// A run without observers, and the integrals about its tips.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/fracture/intensity.hpp"

#include <utility>

#include "base/stop.hpp"
#include "model/continuum.hpp"
#include "run/bodies/planned_bodies.hpp"
#include "run/growth/solution_of.hpp"
#include "run/prepare.hpp"
#include "run/steppers.hpp"

namespace keyblock::study {
namespace {

GrowthCriterion criterion_of(const Problem& problem) {
  return problem.covers && problem.covers->growth ? problem.covers->growth->criterion : GrowthCriterion::hoop_stress;
}

Place place_of(const Problem& problem) {
  return problem.covers ? problem.covers->place : problem.analysis->place;
}

}  // namespace

CaseIntensity intensity_at_end(Problem problem, const std::string& profile, const std::vector<Override>& overrides,
                               const std::function<bool()>& wants_stop) {
  const GrowthCriterion criterion = criterion_of(problem);
  if (problem.covers) {
    problem.covers->mesh.tip_side = tip_side_of(*problem.covers);
    problem.covers->growth.reset();
  }
  Prepared prepared = prepare(problem, profile, overrides);
  if (!prepared.scene.model.continuum)
    throw InputError(place_of(problem), "expected bodies on covers, in which cracks end, found blocks alone");
  CaseIntensity result;
  result.warnings = std::move(prepared.warnings);
  result.unknowns = prepared.requirements.unknowns;
  const std::unique_ptr<Stepper> stepper = stepper_for(std::move(prepared.scene));
  while (stepper->state().step < stepper->settings().step_count && !stepper->is_done()) {
    if (wants_stop()) throw StopRequested();
    const auto step = stepper->advance();
    if (const auto* failure = std::get_if<StepFailure>(&step)) {
      result.failure = failure->reason;
      return result;
    }
  }
  result.time = stepper->state().time;
  result.is_in_motion = stepper->settings().standard.motion == MotionRule::dynamic;
  const Continuum& continuum = *stepper->model().continuum;
  if (continuum.manifold.tips.empty())
    throw InputError(place_of(problem), "expected the end of a crack or joint inside a body, found none");
  const CoverSolution solution = *solution_of(*stepper);
  for (const CrackTip& tip : continuum.manifold.tips) {
    TipAtEnd at_end{tip_report(solution, tip), {}, std::nullopt};
    if (at_end.report.factors) at_end.kink = kink(criterion, at_end.report.rock, at_end.report.factors->k);
    const BlockMaterial& rock = continuum.material(std::max(0, element_of(continuum.manifold, tip)));
    if (rock.is_nonlinear())
      throw InputError(rock.place, "expected elastic rock about the tips of cracks, found a strength or crack_closure");
    if (rock.toughness) {
      at_end.toughness = rock.toughness->mode_1;
      if (at_end.report.factors)
        at_end.kink.equivalent = equivalent_of(at_end.kink, *rock.toughness, at_end.report.factors->k);
    }
    result.tips.push_back(std::move(at_end));
  }
  return result;
}

}  // namespace keyblock::study
