// Solves, estimates, marks and refines; see mesh_by_error.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/mesh/mesh_by_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <variant>

#include "base/error.hpp"
#include "base/sentences/sentences.hpp"
#include "cut/mesh/fit_mesh.hpp"
#include "cut/mesh/mesh_size.hpp"
#include "model/continuum.hpp"
#include "run/bodies/planned_bodies.hpp"
#include "run/mesh/stress_error.hpp"
#include "step/linear_stepper.hpp"

namespace keyblock {
namespace {

constexpr double kHalf = 0.5;        // of ‖e‖²
constexpr double kSameError = 1e-6;  // of symmetric places
constexpr double kLow = 3;           // estimates are low at tips, by up to 2.4 (see the tests)
constexpr double kMostChange = 0.5;  // of the energy norm: a greater one confirms nothing at any target
constexpr int kMostMeshRounds = 60;
constexpr double kShortest =
    1e-6;                     // sides, relative to the mesh extent: the only end of refinement at infinite stresses
constexpr double kFew = 0.1;  // of the target error: allowed effect of a point force without a check
constexpr double kAboutPoints = 0.25;  // of the side of the first mesh: nearer to the point, its error does not count

double squared(double v) {
  return v * v;
}

const Place& place_of_mesh(const CoverPlan& plan) {
  return plan.mesh.place.line > 0 ? plan.mesh.place : plan.place;
}

/// Returns the bodies alone, static and elastic, without anything that is ever excavated.
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

double longest_side(const std::array<Point, 3>& t) {
  return std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
}

/// Returns a point at the middle of a triangle, with half of its longest side.
RefinedPoint halved(const std::array<Point, 3>& t) {
  return {(1.0 / 3) * (t[0] + t[1] + t[2]), longest_side(t) / 2};
}

double shortest_side(const TriangleMesh& mesh) {
  Box box;
  for (const Point& node : mesh.nodes) box.add(node);
  return std::max(least_side(box), kShortest * std::max(box.size().x, box.size().y));
}

/// Triangle that may be halved, and the error of its element.
struct Half {
  double error = 0;
  RefinedPoint at;
};

std::vector<Half> halves_of(const Manifold& manifold, const std::vector<double>& error) {
  const double shortest = shortest_side(manifold.mesh);
  std::vector<Half> halves;
  for (std::size_t e = 0; e < error.size(); ++e) {
    const RefinedPoint half = halved(manifold.triangle(manifold.elements[e]));
    if (half.side >= shortest) halves.push_back({error[e], half});
  }
  std::ranges::stable_sort(halves, std::greater(), &Half::error);
  return halves;
}

/// Returns those with the greatest errors, together `share` of the total.
std::vector<RefinedPoint> marked(const std::vector<Half>& halves, double share) {
  double total = 0;
  for (const Half& half : halves) total += half.error;
  std::vector<RefinedPoint> points;
  double sum = 0, last = 0;
  for (const Half& half : halves) {
    if (sum >= share * total && half.error < (1 - kSameError) * last) break;
    sum += half.error;
    last = half.error;
    points.push_back(half.at);
  }
  return points;
}

/// Adds points and drops old ones made redundant by them, in triangles that are halved again.
void put(std::vector<RefinedPoint>& all, const std::vector<RefinedPoint>& more) {
  if (more.empty()) return;
  const MeshSize wanted(std::numeric_limits<double>::infinity(), more, kMeshGrowth);
  std::erase_if(all, [&](const RefinedPoint& old) { return wanted.at(old.at) <= old.side; });
  all.insert(all.end(), more.begin(), more.end());
}

/// Finds points with a force or spring that adds notable strain energy. A force P adds some P²/E each time that sides
/// there are halved, without limit (Flamant 1892).
std::vector<Uncounted> forces_at_points(const Continuum& continuum, const CoverBasis& basis, const Eigen::VectorXd& d,
                                        double felt) {
  std::vector<Uncounted> found;
  const auto look = [&](int element, Point at, double force) {
    const std::array<Point, 3> t =
        continuum.manifold.triangle(continuum.manifold.elements[static_cast<std::size_t>(element)]);
    if (force * force > felt * continuum.material(element).youngs_modulus)
      found.push_back({at, kAboutPoints * longest_side(t)});
  };
  for (const PointForce& force : continuum.point_forces) look(force.element, force.at, length(force.force));
  for (const PointSpring& spring : continuum.point_springs) {
    const ElementShape shape = basis.shape(spring.element);
    const Eigen::RowVectorXd values = shape.values(spring.at);
    Eigen::Vector2d u = Eigen::Vector2d::Zero();
    for (int a = 0; a < shape.function_count(); ++a)
      u += values[a] * d.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]);
    look(spring.element, spring.at, spring.stiffness * dot(spring.direction, {u.x(), u.y()}));
  }
  return found;
}

struct Estimate {
  MeshRound round;
  std::size_t triangles = 0;  ///< of the mesh, which extends beyond the bodies
  double strain = 0;          ///< twice the strain energy
  std::vector<Half> halves;
};

/// Mesh that was not solved.
struct TooLarge {
  int unknowns = 0;
};

class Refinement {
 public:
  Refinement(const Problem& problem, const std::function<Scene(const Problem&, const std::vector<Override>&)>& scene)
      : wanted_(problem.covers->mesh.error),
        most_unknowns_(problem.covers->mesh.most_unknowns),
        place_(place_of_mesh(*problem.covers)),
        scene_(scene),
        result_{problem, {}, {}} {
    MeshPlan& mesh = result_.problem.covers->mesh;
    mesh.error = 0;
    // Otherwise cracks end where they leave the last element, and the stresses of all meshes agree on that.
    mesh.has_nodes_at_tips = true;
  }

  MeshByError result() {
    auto first = estimate();
    if (const auto* large = std::get_if<TooLarge>(&first))
      throw InputError(place_, fmt::format("expected a first mesh of at most most_unknowns = {} unknowns, found {}",
                                           most_unknowns_, large->unknowns));
    Estimate found = std::get<Estimate>(std::move(first));
    result_.rounds.push_back(found.round);
    std::string obstacle;
    is_confirmed_ = found.round.error == 0;
    while (obstacle.empty() && !(is_confirmed_ && found.round.error <= wanted_)) obstacle = refine(found);
    warn(obstacle);
    return std::move(result_);
  }

 private:
  /// Makes one round: refines half of the error, or all triangles of a first mesh. If a mesh with a small enough error
  /// awaits confirmation and the finer one agrees, the mesh stays. Returns the obstacle, if any.
  std::string refine(Estimate& found) {
    if (result_.rounds.size() == kMostMeshRounds) return fmt::format("after {} rounds", kMostMeshRounds);
    if (found.halves.empty()) return "its sides can be no shorter";
    const bool is_to_confirm = found.round.error <= wanted_;
    std::vector<RefinedPoint>& refined = result_.problem.covers->mesh.refined;
    const std::vector<RefinedPoint> before = refined;
    put(refined, marked(found.halves, is_to_confirm && result_.rounds.size() == 1 ? 1 : kHalf));
    auto next = estimate();
    if (std::holds_alternative<TooLarge>(next)) {
      refined = before;
      return fmt::format("the next mesh would have more than most_unknowns = {}", most_unknowns_);
    }
    const Estimate last = std::exchange(found, std::get<Estimate>(std::move(next)));
    is_confirmed_ = agrees(last, found);
    if (is_to_confirm && is_confirmed_ && found.round.error <= wanted_) {
      refined = before;
      found = last;
      return "";
    }
    result_.rounds.push_back(found.round);
    const bool is_done = is_confirmed_ && found.round.error <= wanted_;
    return found.triangles == last.triangles && !is_done ? "refinement no longer changes it" : "";
  }

  /// Returns true if a mesh changed the energy by no more than the estimated error of the last one. If sides exceed the
  /// width of a body, stresses hardly differ and the estimate is meaningless.
  bool agrees(const Estimate& last, const Estimate& now) const {
    const double estimate = std::min(kMostChange, kLow * std::max(wanted_, last.round.error));
    return std::abs(now.strain - last.strain) <= estimate * estimate * now.strain;
  }

  void warn(const std::string& obstacle) {
    if (!uncounted_.empty()) {
      Facts facts{{{"count", uncounted_.size()}, {"radius", uncounted_.front().radius}},
                  {{"carry", uncounted_.size() == 1 ? "carries a force" : "carry forces"}}};
      for (const auto& point : uncounted_) facts.points.push_back({point.at.x, point.at.y});
      result_.warnings.push_back(warning_of({"mesh_error_at_points", std::move(facts)}, place_));
    }
    if (obstacle.empty()) return;
    const double error = result_.rounds.back().error;
    const char* const form = error > wanted_ ? "mesh_error_not_reached" : "mesh_error_not_reached:unconfirmed";
    result_.warnings.push_back(
        warning_of({form, {{{"error", error}, {"permitted", wanted_}}, {{"obstacle", obstacle}}}}, place_));
  }

  std::variant<Estimate, TooLarge> estimate() {
    const Problem still = still_bodies(result_.problem);
    Scene scene = scene_(still, kAtRest);
    if (!scene.is_untouched || !scene.model.continuum)
      throw InputError(place_, "expected only NMM bodies for an error of the mesh, found blocks too");
    const CoverBasis basis = basis_of(*scene.model.continuum);
    const int unknowns = 2 * basis.function_count();
    if (unknowns > most_unknowns_) return TooLarge{unknowns};
    LinearStepper stepper(std::move(scene));
    const auto step = stepper.advance();
    if (const auto* failure = std::get_if<StepFailure>(&step))
      throw InputError(place_,
                       "expected bodies that their supports fix without contact, for an error of the mesh, found: " +
                           failure->reason);
    const Continuum& continuum = *stepper.model().continuum;
    const Eigen::VectorXd& d = stepper.on_covers()->d;
    StressError error = stress_error(continuum, basis, d, uncounted_);
    if (result_.rounds.empty()) {
      uncounted_ = forces_at_points(continuum, basis, d, squared(kFew * wanted_) * error.strain);
      if (!uncounted_.empty()) error = stress_error(continuum, basis, d, uncounted_);
    }
    return Estimate{{basis.element_count(), unknowns, error.share()},
                    continuum.manifold.mesh.triangles.size(),
                    error.strain,
                    halves_of(continuum.manifold, error.of_element)};
  }

  double wanted_;
  int most_unknowns_;
  Place place_;
  const std::function<Scene(const Problem&, const std::vector<Override>&)>& scene_;
  MeshByError result_;
  std::vector<Uncounted> uncounted_;  // known from the first mesh on
  bool is_confirmed_ = false;         // true if the last mesh confirms the estimate before it
};

}  // namespace

bool has_mesh_by_error(const Problem& problem) {
  return problem.covers && problem.covers->mesh.error > 0;
}

std::string MeshByError::sentence() const {
  if (rounds.empty()) return "";
  const std::size_t times = rounds.size() - 1;
  return fmt::format("{}, stresses are estimated to be off by {:.2g} of the energy norm",
                     times == 0   ? "mesh not refined"
                     : times == 1 ? "mesh refined once"
                                  : fmt::format("mesh refined {} times", times),
                     rounds.back().error);
}

MeshByError mesh_by_error(const Problem& problem,
                          const std::function<Scene(const Problem&, const std::vector<Override>&)>& scene) {
  return Refinement(problem, scene).result();
}

}  // namespace keyblock
