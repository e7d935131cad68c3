// Solve, estimate, mark, refine; see mesh_by_error.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/mesh/mesh_by_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "cut/mesh/fit_mesh.hpp"
#include "model/continuum.hpp"
#include "run/bodies/planned_bodies.hpp"
#include "run/mesh/stress_error.hpp"
#include "step/linear_stepper.hpp"

namespace keyblock {
namespace {

constexpr double kHalf = 0.5;        // of ‖e‖²
constexpr double kSameError = 1e-6;  // of symmetric places
constexpr int kMostRounds = 40;      // each at least halves some sides: 1e-12 of the first ones

const Place& place_of_mesh(const CoverPlan& plan) {
  return plan.mesh.place.line > 0 ? plan.mesh.place : plan.place;
}

/// The bodies alone, at rest, elastic, with all that is ever dug out gone.
Problem still_bodies(const Problem& problem) {
  Problem still = problem;
  CoverPlan& plan = *still.covers;
  plan.functions = functions_of(plan, still.analysis->block_materials);
  plan.contact = CoverContact::ignored;
  plan.mesh.error = 0;
  plan.mesh.tip_side = tip_side_of(plan);
  plan.growth.reset();
  for (const Stage& stage : still.stages)
    for (const StageExcavation& dug : stage.excavations)
      plan.excavations.push_back({1, dug.outline, dug.place, dug.joint_material});
  for (ExcavationPlan& dug : plan.excavations) dug.step = 1;
  still.stages.clear();
  for (BlockMaterial& material : still.analysis->block_materials) {
    material.strength = {};
    material.crack_closure = {};
  }
  return still;
}

const std::vector<Override> kAtRest{
    {"motion", "static"}, {"velocity_carry_over", "0"}, {"steps", "1"}, {"load_control", "share"}};

/// Elements with the greatest errors, together kHalf of all.
std::vector<int> marked(const StressError& error) {
  std::vector<int> order(error.of_element.size());
  std::iota(order.begin(), order.end(), 0);
  const auto of = [&](int e) { return error.of_element[static_cast<std::size_t>(e)]; };
  std::ranges::stable_sort(order, [&](int a, int b) { return of(a) > of(b); });
  double sum = 0;
  std::size_t count = 0;
  while (count < order.size() && sum < kHalf * error.total) sum += of(order[count++]);
  while (count > 0 && count < order.size() && of(order[count]) >= (1 - kSameError) * of(order[count - 1])) ++count;
  order.resize(count);
  return order;
}

/// At the middle of a triangle, half of its longest side.
RefinedPoint halved(const std::array<Point, 3>& t) {
  const double longest = std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
  return {(1.0 / 3) * (t[0] + t[1] + t[2]), longest / 2};
}

/// Without those that others make needless.
void put(std::vector<RefinedPoint>& all, const std::vector<RefinedPoint>& more) {
  for (const RefinedPoint& point : more) {
    std::erase_if(all, [&](const RefinedPoint& old) {
      return point.side + kMeshGrowth * distance(point.at, old.at) <= old.side;
    });
    all.push_back(point);
  }
}

struct Estimate {
  MeshRound round;
  std::vector<RefinedPoint> finer;
};

class Refinement {
 public:
  Refinement(const Problem& problem, const std::function<Scene(const Problem&, const std::vector<Override>&)>& scene)
      : scene_(scene), result_{problem, {}, {}} {
    MeshPlan& mesh = result_.problem.covers->mesh;
    mesh.error = 0;
    // Else cracks end where they leave the last element, and no difference of stresses says so.
    mesh.has_nodes_at_tips = true;
  }

  MeshByError result(double wanted, int most_unknowns) {
    Estimate found = estimate();
    result_.rounds.push_back(found.round);
    while (found.round.error > wanted && result_.rounds.size() < kMostRounds) {
      std::vector<RefinedPoint>& refined = result_.problem.covers->mesh.refined;
      const std::vector<RefinedPoint> before = refined;
      put(refined, found.finer);
      const std::optional<Estimate> next = estimate_below(most_unknowns);
      if (!next) {
        refined = before;
        break;
      }
      found = *next;
      result_.rounds.push_back(found.round);
    }
    if (found.round.error > wanted)
      result_.warnings.push_back(
          {"mesh_error_not_reached", place_of_mesh(*result_.problem.covers),
           fmt::format(
               "the stresses of the mesh are estimated to be off by {:.2g} of the energy norm, not by the error "
               "of {:.2g} asked for: the next mesh would have more than most_unknowns = {}",
               found.round.error, wanted, most_unknowns)});
    return std::move(result_);
  }

 private:
  Estimate estimate() { return *estimate_below(std::numeric_limits<int>::max()); }

  /// None for a mesh of more unknowns.
  std::optional<Estimate> estimate_below(int most_unknowns) {
    const Problem still = still_bodies(result_.problem);
    const Place& place = place_of_mesh(*still.covers);
    Scene scene = scene_(still, kAtRest);
    if (!scene.is_untouched || !scene.model.continuum)
      throw InputError(place,
                       "expected all bodies on covers beside an error of the mesh, which is found on them alone, found "
                       "blocks beside them");
    const CoverBasis basis = basis_of(*scene.model.continuum);
    if (2 * basis.function_count() > most_unknowns) return std::nullopt;
    LinearStepper stepper(std::move(scene));
    const auto step = stepper.advance();
    if (const auto* failure = std::get_if<StepFailure>(&step))
      throw InputError(place,
                       "expected bodies that their supports hold without contact beside an error of the mesh, which is "
                       "found on them alone at rest, found: " +
                           failure->reason);
    const Continuum& continuum = *stepper.model().continuum;
    const StressError error = stress_error(continuum, basis, stepper.on_covers()->d);
    Estimate found{{basis.element_count(), 2 * basis.function_count(), error.share()}, {}};
    for (const int e : marked(error))
      found.finer.push_back(
          halved(continuum.manifold.triangle(continuum.manifold.elements[static_cast<std::size_t>(e)])));
    return found;
  }

  const std::function<Scene(const Problem&, const std::vector<Override>&)>& scene_;
  MeshByError result_;
};

}  // namespace

bool has_mesh_by_error(const Problem& problem) {
  return problem.covers && problem.covers->mesh.error > 0;
}

std::string MeshByError::sentence() const {
  const MeshRound& last = rounds.back();
  return fmt::format("mesh refined {} times, to stresses that are estimated to be off by {:.2g} of the energy norm",
                     rounds.size() - 1, last.error);
}

MeshByError mesh_by_error(const Problem& problem,
                          const std::function<Scene(const Problem&, const std::vector<Override>&)>& scene) {
  const MeshPlan& mesh = problem.covers->mesh;
  return Refinement(problem, scene).result(mesh.error, mesh.most_unknowns);
}

}  // namespace keyblock
