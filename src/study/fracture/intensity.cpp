// Runs the case without observers and evaluates the integrals about its tips.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/fracture/intensity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/context.hpp"
#include "model/continuum.hpp"
#include "run/bodies/planned_bodies.hpp"
#include "run/growth/bonded_faces.hpp"
#include "run/growth/solution_of.hpp"
#include "run/prepare.hpp"
#include "run/steppers.hpp"

namespace keyblock::study {
namespace {

constexpr double kFarApart = 0.03;  // of |K|, between treatments: the same limit as between domains

GrowthCriterion criterion_of(const Problem& problem) {
  return problem.covers && problem.covers->growth ? problem.covers->growth->criterion : GrowthCriterion::hoop_stress;
}

Place place_of(const Problem& problem) {
  return problem.covers ? problem.covers->place : problem.analysis->place;
}

bool has_tips(const Model& model) {
  return model.continuum && !model.continuum->manifold.tips.empty();
}

IntensityPlan plan_of(ConfiguredCase made) {
  Problem& problem = made.problem;
  const GrowthCriterion criterion = criterion_of(problem);
  if (problem.covers) {
    problem.covers->mesh.tip_side = tip_side_of(*problem.covers);
    problem.covers->growth.reset();
  }
  Prepared prepared = prepared_case(made);
  if (!prepared.scene.model.continuum)
    throw InputError(place_of(problem), "expected NMM bodies, in which cracks can end, found only blocks");
  if (!has_tips(scenes_of(prepared.scene).back()->model))
    throw InputError(place_of(problem), "expected the end of a crack or joint inside a body, found none");
  Warnings warnings = joined(prepared.warnings, bonded_crack_faces(prepared.scene, place_of(problem)));
  return {criterion, std::move(made), std::move(prepared), std::move(warnings)};
}

/// Takes the scene of the plan.
CaseIntensity intensity_by_one(IntensityPlan& plan) {
  CaseIntensity result;
  result.unknowns = plan.prepared.requirements.unknowns;
  const std::unique_ptr<Stepper> stepper = stepper_for(std::move(plan.prepared.scene));
  while (stepper->state().step < stepper->settings().step_count && !stepper->is_done()) {
    leave_if_stopped();
    const auto step = stepper->advance();
    if (const auto* failure = std::get_if<StepFailure>(&step)) {
      result.failure = failure->reason;
      return result;
    }
  }
  result.time = stepper->state().time;
  result.is_in_motion = stepper->settings().standard.motion == MotionRule::dynamic;
  const Continuum& continuum = *stepper->model().continuum;
  const CoverSolution solution = *solution_of(*stepper);
  for (const CrackTip& tip : continuum.manifold.tips) {
    TipAtEnd at_end{tip_report(solution, tip), {}, std::nullopt};
    if (at_end.report.factors) at_end.kink = kink(plan.criterion, at_end.report.rock, at_end.report.factors->k);
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

// Sides per room around the narrowest tip: K within 0.3 % by functions, within 0.7 % by bisection.
constexpr double kSidesWithFunctions = 8, kSidesWithout = 320;

/// Returns the case with the other treatment of its tips.
ConfiguredCase with_other_treatment(ConfiguredCase made, const CaseIntensity& found) {
  double room = found.tips.front().report.tip.room;
  for (const TipAtEnd& tip : found.tips) room = std::min(room, tip.report.tip.room);
  MeshPlan& mesh = made.problem.covers->mesh;
  mesh.tip_functions = found.has_functions ? TipFunctionPlan{} : TipFunctionPlan{TipFunctions::williams, 0};
  mesh.tip_side = room / (found.has_functions ? kSidesWithout : kSidesWithFunctions);
  return made;
}

void put_other_treatment(CaseIntensity& found, const CaseIntensity& other) {
  if (!other.failure.empty() || other.tips.size() != found.tips.size()) {
    found.no_other = other.failure.empty() ? "its mesh has other tips" : other.failure;
    return;
  }
  found.other_unknowns = other.unknowns;
  for (std::size_t i = 0; i < found.tips.size(); ++i)
    found.tips[i].other = OtherTreatment{other.tips[i].report.side, other.tips[i].report.factors};
}

}  // namespace

bool has_both(const TipAtEnd& tip) {
  return tip.report.factors && tip.other && tip.other->factors;
}

StressIntensity difference(const TipAtEnd& tip) {
  const StressIntensity& own = tip.report.factors->k;
  const StressIntensity& other = tip.other->factors->k;
  const double size = std::hypot(own.mode_1, own.mode_2);
  if (size == 0) return {};
  return {(own.mode_1 - other.mode_1) / size, (own.mode_2 - other.mode_2) / size};
}

std::string doubt_of(const TipAtEnd& tip) {
  if (std::string doubt = doubt_of(tip.report); !doubt.empty() || !has_both(tip)) return doubt;
  const StressIntensity d = difference(tip);
  const double apart = std::max(std::abs(d.mode_1), std::abs(d.mode_2));
  if (!(apart > kFarApart)) return {};
  return fmt::format("the treatments with and without near-tip functions are {:.2g} % of K apart: a finer mesh",
                     100 * apart);
}

IntensityPlan intensity_plan(const AskedCase& asked, const formats::Case& input) {
  IntensityPlan plan = plan_of(configured(asked, input.problem, OldFiles::standard));
  plan.warnings = joined(input.warnings, plan.warnings);
  return plan;
}

CaseIntensity intensity_at_end(IntensityPlan plan) {
  CaseIntensity found = intensity_by_one(plan);
  if (!found.failure.empty()) return found;
  if (!plan.made.problem.covers) {
    found.no_other = "the case has no plan of covers";
    return found;
  }
  found.has_functions = plan.made.problem.covers->mesh.tip_functions.are_asked();
  if (found.is_in_motion) {
    found.no_other = "near-tip functions are of linear statics";
    return found;
  }
  try {
    IntensityPlan other = plan_of(with_other_treatment(std::move(plan.made), found));
    put_other_treatment(found, intensity_by_one(other));
  } catch (const InputError& error) {
    found.no_other = error.sentence();
  }
  return found;
}

}  // namespace keyblock::study
