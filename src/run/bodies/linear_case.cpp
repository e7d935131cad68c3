// Turns excavations of the plan into changes of the scene, as stages do.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/linear_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "base/error.hpp"
#include "model/cover_basis.hpp"
#include "run/bodies/planned_bodies.hpp"

namespace keyblock {
namespace {

bool has_fixed_or_loading_points(const Problem& problem) {
  const auto has_points = [](const auto& geometry) {
    if constexpr (requires { geometry.fixed_points; })
      return !geometry.fixed_points.empty() || !geometry.loading_points.empty();
    else if constexpr (requires { geometry.fixed_lines; })
      return !geometry.fixed_lines.empty() || !geometry.loading_points.empty();
    else
      return false;
  };
  return std::visit(has_points, problem.geometry);
}

bool has_bolts(const Problem& problem) {
  const auto has = [](const auto& geometry) {
    if constexpr (requires { geometry.bolts; })
      return !geometry.bolts.empty();
    else
      return false;
  };
  return std::visit(has, problem.geometry);
}

void drop_points_and_bolts(Problem& problem) {
  const auto drop = [](auto& geometry) {
    if constexpr (requires { geometry.bolts; }) geometry.bolts.clear();
    if constexpr (requires { geometry.fixed_points; }) geometry.fixed_points.clear();
    if constexpr (requires { geometry.fixed_lines; }) geometry.fixed_lines.clear();
    if constexpr (requires { geometry.loading_points; }) geometry.loading_points.clear();
  };
  std::visit(drop, problem.geometry);
  problem.analysis->point_loads.clear();
  problem.analysis->fixed_point_motions.clear();
}

// With contact and without excavation, a linear solution covers the whole case (is_linear).
Warnings without_effect(const Problem& problem) {
  Warnings warnings;
  if (problem.covers->contact == CoverContact::felt && problem.covers->excavations.empty()) return warnings;
  const Place& place = problem.covers->place;
  if (has_bolts(problem))
    warnings.push_back(
        {"bolts_without_effect", place, "bolts have no effect if contact is ignored or regions are excavated"});
  if (has_fixed_or_loading_points(problem))
    warnings.push_back({"points_without_effect", place,
                        "fixed and loading points have no effect if contact is ignored or regions are excavated"});
  // A user who sets contact to ignored needs no warning.
  if (problem.covers->contact == CoverContact::felt && bodies_touch(problem))
    warnings.push_back({"contact_without_effect", place,
                        "bodies and the two sides of a joint pass through each other, because `excavations` are solved "
                        "without contact"});
  return warnings;
}

}  // namespace

bool is_untouched(const Problem& problem, const Settings& settings) {
  if (!problem.covers || !problem.stages.empty()) return false;
  if (!problem.covers->excavations.empty()) {
    if (settings.dynamics != Dynamics::standard)
      throw InputError(problem.covers->place, "expected profile standard for NMM bodies, found legacy");
    if (!is_statics(settings))
      throw InputError(problem.covers->excavations.front().place,
                       fmt::format("expected statics for excavations (velocity_carry_over 0), found {}",
                                   problem.analysis->velocity_carry_over));
    return true;
  }
  if (!is_statics(settings) || !problem.covers->mesh.materials.empty()) return false;
  if (problem.covers->contact == CoverContact::ignored) return true;
  if (has_fixed_or_loading_points(problem) || has_bolts(problem)) return false;
  return !bodies_touch(problem) || (problem.covers->mesh.tip_functions.are_asked() && only_faces_touch(problem));
}

bool faces_touch(const Problem& problem) {
  const CoverPlan& covers = *problem.covers;
  return covers.mesh.tip_functions.are_asked() && covers.contact == CoverContact::felt && covers.excavations.empty() &&
         problem.stages.empty();
}

void require_linear_tips(const Problem& problem, const Settings& settings) {
  if (!problem.covers || !problem.covers->mesh.tip_functions.are_asked()) return;
  const auto refuse = [&](const std::string& found) {
    const Place& mesh = problem.covers->mesh.place;
    throw InputError(mesh.line > 0 ? mesh : problem.covers->place,
                     "expected linear statics of elastic rock for tip_functions (velocity_carry_over 0, contact "
                     "ignored or only of the faces of cracks of one body, functions derived or linear), found " +
                         found);
  };
  if (!is_statics(settings)) refuse("dynamics");
  if (problem.covers->growth) refuse("crack growth");
  if (!problem.stages.empty()) refuse("stages");
  if (!problem.covers->mesh.materials.empty()) refuse("blocks among the NMM bodies");
  if (!is_untouched(problem, settings))
    refuse("contact of several bodies, or contact with fixed points, loading points or bolts");
  if (faces_touch(problem) && std::ranges::any_of(problem.analysis->joint_materials, &JointMaterial::has_strength))
    refuse("cohesion or tensile strength of joints whose faces touch");
  const std::vector<BlockMaterial>& materials = problem.analysis->block_materials;
  if (std::ranges::any_of(materials, &BlockMaterial::is_nonlinear)) refuse("a strength or crack_closure");
  const CoverFunctions functions = functions_of(*problem.covers, materials);
  if (functions == CoverFunctions::constant || functions == CoverFunctions::quadratic)
    refuse(fmt::format("{} functions", name_of(functions)));
}

LinearCase linear_case(const Problem& problem, const Settings& settings) {
  LinearCase made{problem, {}, without_effect(problem)};
  drop_points_and_bolts(made.problem);
  std::vector<ExcavationPlan> excavations = std::exchange(made.problem.covers->excavations, {});
  if (excavations.empty()) return made;
  std::set<int> starts{1};
  for (const ExcavationPlan& excavation : excavations) {
    if (excavation.step < 1 || excavation.step > settings.step_count)
      throw InputError(excavation.place, fmt::format("expected a load step from 1 to {}, the step_count, found {}",
                                                     settings.step_count, excavation.step));
    starts.insert(excavation.step);
  }
  for (auto start = starts.begin(); start != starts.end(); ++start) {
    const auto next = std::next(start);
    made.steps.push_back((next == starts.end() ? settings.step_count + 1 : *next) - *start);
    Stage& stage = made.problem.stages.emplace_back();
    stage.steps = made.steps.back();
    stage.place = excavations.front().place;
    for (const ExcavationPlan& excavation : excavations)
      if (excavation.step == *start)
        stage.excavations.push_back({excavation.outline, excavation.joint_material, excavation.place});
  }
  return made;
}

}  // namespace keyblock
