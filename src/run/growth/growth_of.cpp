// Checks the conditions of crack growth, then makes the function that recuts the scene; see growth_of.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/growth/growth_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "geometry/box.hpp"
#include "model/continuum.hpp"
#include "run/bodies/planned_bodies.hpp"

namespace keyblock {
namespace {

constexpr double kLeastIncrements = 4;  // across all bodies: longer ones follow no path

GrowthLoads loads_of(const Problem& problem, const Scene& scene) {
  if (problem.covers->growth->loads != GrowthLoads::automatic) return problem.covers->growth->loads;
  return is_statics(scene.settings) && problem.covers->mesh.materials.empty() ? GrowthLoads::scaled
                                                                              : GrowthLoads::given;
}

std::string why_not_scaled(const Problem& problem, const Scene& scene) {
  if (!is_statics(scene.settings))
    return "expected statics for crack growth under scaled loads (velocity_carry_over 0, profile standard), found "
           "dynamics, which needs given loads";
  if (!problem.covers->mesh.materials.empty())
    return "expected only NMM bodies for crack growth under scaled loads (no materials of the mesh), found blocks";
  if (scene.model.continuum->initial_stress ||
      std::ranges::any_of(problem.analysis->block_materials, &BlockMaterial::is_stressed))
    return "expected no initial stress for crack growth under scaled loads, found one: all loads have one factor";
  if (!scene.model.loading_points.empty())
    return "expected loads of covers (forces, tractions) for crack growth under scaled loads, found loading points";
  return {};
}

std::string why_not_given(const Scene& scene) {
  if (scene.settings.dynamics != Dynamics::standard) return "expected profile standard for crack growth, found legacy";
  if (scene.is_untouched) return "expected contact felt for crack growth under given loads, found it ignored";
  return {};
}

std::string why_not(const Problem& problem, const Scene& scene) {
  const std::vector<BlockMaterial>& materials = problem.analysis->block_materials;
  if (!scene.model.continuum) return "expected NMM bodies for crack growth, found none";
  if (!problem.stages.empty() || !problem.covers->excavations.empty())
    return "expected no stages or excavations with crack growth, found them";
  if (std::ranges::any_of(materials, &BlockMaterial::is_nonlinear))
    return "expected elastic rock for crack growth, found a strength or crack_closure";
  const std::string why =
      loads_of(problem, scene) == GrowthLoads::scaled ? why_not_scaled(problem, scene) : why_not_given(scene);
  if (!why.empty()) return why;
  Box box;
  for (const ElementCorner& corner : scene.model.continuum->manifold.corners) box.add(corner.position);
  const double longest = std::min(box.size().x, box.size().y) / kLeastIncrements;
  if (problem.covers->growth->increment > longest)
    return fmt::format("expected an increment of at most {:.4g}, a quarter of the bodies' lesser extent, found {:.4g}",
                       longest, problem.covers->growth->increment);
  if (problem.covers->contact == CoverContact::ignored &&
      std::ranges::any_of(materials, [](const BlockMaterial& m) { return m.toughness && m.toughness->cohesion; }))
    return "expected contact felt for cracks that start in shear, found it ignored";
  if (std::ranges::none_of(materials, [](const BlockMaterial& m) { return m.toughness.has_value(); }))
    return "expected a toughness of a block material for crack growth, found none";
  return {};
}

}  // namespace

std::shared_ptr<const CrackGrowth> growth_of(const Problem& problem, const Scene& scene,
                                             std::function<Scene(const Problem&)> remade) {
  if (!problem.covers || !problem.covers->growth) return nullptr;
  const GrowthPlan& plan = *problem.covers->growth;
  if (const std::string why = why_not(problem, scene); !why.empty())
    throw InputError(plan.place.line > 0 ? plan.place : problem.covers->place, why);
  Problem still = problem;
  still.covers->mesh.tip_side = tip_side_of(*still.covers);
  still.covers->growth.reset();
  GrowthPlan chosen = plan;
  chosen.loads = loads_of(problem, scene);
  const double tip_side = still.covers->mesh.tip_side;
  const auto with = [still = std::move(still), remade = std::move(remade)](const std::vector<CrackPlan>& cracks,
                                                                           const std::vector<RefinedPoint>& refined) {
    Problem other = still;
    other.covers->cracks = cracks;
    std::vector<RefinedPoint>& all = other.covers->mesh.refined;
    all.insert(all.end(), refined.begin(), refined.end());
    return remade(other);
  };
  return std::make_shared<CrackGrowth>(CrackGrowth{chosen, problem.covers->cracks, with, tip_side});
}

}  // namespace keyblock
