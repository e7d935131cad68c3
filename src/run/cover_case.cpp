// From plan to continuum to frames; see cover_case.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/cover_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <optional>
#include <string_view>
#include <utility>

#include "geometry/polygon.hpp"
#include "model/continuum.hpp"
#include "model/setup/free_pieces.hpp"
#include "run/bodies/cover_plan_parts.hpp"
#include "run/bodies/planned_bodies.hpp"
#include "run/prepare.hpp"
#include "settings/profile.hpp"

namespace keyblock {
namespace {

// A chain that covers less than this share of its length is told.
constexpr double kAlmostAll = 1 - 1e-6;

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Of the settings these alone say anything of linear statics.
constexpr std::array<std::string_view, 7> kRead{"plane", "gravity",   "gravity.x", "gravity.y",
                                                "steps", "time_step", "motion"};

// Statics, by the analysis or by the settings.
void require_statics(const Problem& problem, const std::string& profile, const Settings& settings) {
  if (rules_of(profile) != "standard")
    throw InputError(problem.covers->place,
                     fmt::format("expected profile standard for bodies on covers, found {}", profile));
  if (settings.standard.motion != MotionRule::equilibrium)
    throw InputError(
        problem.covers->excavations.empty() ? problem.analysis->place : problem.covers->excavations.front().place,
        fmt::format("expected statics where regions are dug out (velocity_carry_over 0), found {}",
                    problem.analysis->velocity_carry_over));
}

Warnings settings_without_effect(const Problem& problem, const std::vector<Override>& overrides) {
  Warnings warnings;
  const auto look = [&](const Override& setting, const Place& place) {
    if (std::ranges::find(kRead, setting.first) == kRead.end())
      warnings.push_back({"setting_without_effect", place,
                          fmt::format("setting {} has no effect on a linear static solution", setting.first)});
  };
  const RunChoices& choices = problem.choices;
  for (std::size_t i = 0; i < choices.settings.size(); ++i)
    look(choices.settings[i], i < choices.setting_places.size() ? choices.setting_places[i] : choices.place);
  for (const Override& setting : overrides) look(setting, problem.covers->place);
  return warnings;
}

Warnings without_effect(const Problem& problem, bool touches) {
  Warnings warnings;
  const Place& place = problem.covers->place;
  if (has_bolts(problem))
    warnings.push_back(
        {"bolts_without_effect", place, "bolts have no effect where contact is ignored or regions are dug out"});
  if (has_fixed_or_loading_points(problem))
    warnings.push_back({"points_without_effect", place,
                        "fixed and loading points have no effect where contact is ignored or regions are dug out: name "
                        "displacements and forces of `covers` instead"});
  if (touches)
    warnings.push_back(
        {"contact_without_effect", place,
         "bodies and the two sides of a joint do not feel each other: contact is ignored, or regions are dug out"});
  return warnings;
}

double length_of(const BoundaryPart& part) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < part.size(); ++i) sum += distance(part[i], part[i + 1]);
  return sum;
}

double length_found(const Manifold& manifold, const BoundaryPart& part) {
  double sum = 0;
  for (const ElementSide& side : sides_along(manifold, part)) sum += distance(side.edge.start, side.edge.end);
  return sum;
}

using Reader = std::function<FieldCorner(int element, Point)>;

FieldFrame field_of(const Manifold& manifold, int step, double time, const Reader& read) {
  FieldFrame field{step, time, {}};
  for (std::size_t e = 0; e < manifold.elements.size(); ++e) {
    const ManifoldElement& element = manifold.elements[e];
    const int number = static_cast<int>(e);
    FieldElement& out = field.elements.emplace_back();
    out.body = element.body;
    out.material = manifold.body_materials[static_cast<std::size_t>(element.body)];
    const auto loops = manifold.polygon(element);
    for (const auto& loop : loops) {
      out.loops.emplace_back();
      for (const Point p : loop) out.loops.back().push_back(read(number, p));
    }
    out.middle = read(number, centroid(loops.front()));
  }
  return field;
}

Frame frame_of(const FieldFrame& field, const std::vector<BlockMaterial>& materials) {
  Frame frame{field.step, field.time, {}, {}, {}, {}, {}};
  for (const FieldElement& element : field.elements) {
    ElementFrame out{};
    double area_now = 0;
    double area_before = 0;
    for (const auto& loop : element.loops) {
      std::vector<Point> before;
      out.loops.emplace_back();
      for (const FieldCorner& corner : loop) {
        before.push_back(corner.position);
        out.loops.back().push_back(corner.position + corner.displacement);
      }
      area_now += area(out.loops.back());
      area_before += area(before);
    }
    out.material = element.material;
    out.centroid = element.middle.position + element.middle.displacement;
    out.displacement = element.middle.displacement;
    out.stress = element.middle.stress;
    out.area = area_now;
    out.mass = materials[static_cast<std::size_t>(element.material)].density * area_before;
    frame.elements.push_back(std::move(out));
  }
  return frame;
}

}  // namespace

struct CoverCase::Parts {
  Problem problem;
  Settings settings;
  PlannedBodies bodies;
  Warnings warnings;
  Continuum loads;  ///< all that depends on no mesh
  SolvedStep start;
  int load_steps = 1;

  Parts(const Problem& from, Settings chosen, const std::vector<Override>& overrides)
      : problem(from), settings(std::move(chosen)), bodies(problem) {
    const CoverPlan& plan = *problem.covers;
    loads = continuum_of({}, problem.analysis->block_materials, settings, plan.functions);
    put_loads(loads, plan);
    load_steps = settings.step_count;
    for (const ExcavationPlan& excavation : plan.excavations)
      if (excavation.step > load_steps)
        throw InputError(excavation.place, fmt::format("expected a load step from 1 to {}, the step_count, found {}",
                                                       load_steps, excavation.step));
    warnings = joined(bodies.warnings(), without_effect(problem, bodies.touches()));
    warnings = joined(std::move(warnings), settings_without_effect(problem, overrides));
    const Continuum whole = continuum_at(0);
    look_at_chains(whole.manifold);
    start.counts = counts_of(whole.manifold, CoverBasis(whole.manifold, whole.functions));
    put_frames(start, whole, nullptr);
  }

  Continuum continuum_at(int step) const {
    Continuum continuum = loads;
    continuum.manifold = bodies.at(step);
    put_points(continuum, *problem.covers);
    return continuum;
  }

  // A boundary may be dug free later.
  void look_at_chains(const Manifold& whole) {
    std::vector<Manifold> stages;
    for (int step = 1; step <= load_steps && !problem.covers->excavations.empty(); ++step)
      if (bodies.changes_at(step)) stages.push_back(bodies.at(step));
    const auto look = [&](const BoundaryPart& part, const Place& place) {
      double found = length_found(whole, part);
      for (const Manifold& stage : stages) found = std::max(found, length_found(stage, part));
      if (found == 0)
        throw InputError(place, fmt::format("expected a chain on the boundary of the bodies, found none of it there: "
                                            "({:.9g}, {:.9g}), …",
                                            part.front().x, part.front().y));
      if (found < kAlmostAll * length_of(part))
        warnings.push_back({"chain_off_boundary", place,
                            fmt::format("only {:.6g} of the {:.6g} of this chain lie on the boundary of the bodies",
                                        found, length_of(part))});
    };
    for (const TractionPlan& part : problem.covers->tractions) look(part.along, part.place);
    for (const DisplacementPlan& part : problem.covers->displacements) look(part.along, part.place);
  }

  CoverCounts counts_of(const Manifold& manifold, const CoverBasis& basis) const {
    CoverCounts counts;
    counts.functions = loads.functions;
    counts.bodies = static_cast<int>(manifold.body_materials.size());
    counts.elements = static_cast<int>(manifold.elements.size());
    counts.covers = static_cast<int>(manifold.covers.size());
    counts.unknowns = 2 * basis.function_count();
    counts.load_steps = load_steps;
    counts.solves = 1;
    for (int step = 2; step <= load_steps; ++step) counts.solves += bodies.changes_at(step) ? 1 : 0;
    return counts;
  }

  void put_frames(SolvedStep& to, const Continuum& continuum, const ContinuumSolution* solution) const {
    const Reader read = [&](int element, Point p) {
      FieldCorner corner{p, {}, {}};
      if (solution != nullptr) {
        corner.displacement = solution->displacement(element, p);
        corner.stress = stress_at(continuum, *solution, element, p);
      } else {
        corner.stress = continuum.initial_stress_at(element, p);
      }
      return corner;
    };
    to.field = field_of(continuum.manifold, to.step, to.time, read);
    to.frame = frame_of(to.field, continuum.materials);
    const bool is_whole = problem.covers->excavations.empty();
    for (const BlockPoint& point : bodies.measured_points()) {
      const int element = element_holding(continuum.manifold, is_whole ? point.block : -1, point.position,
                                          "a measured point", point.place);
      const FieldCorner at = read(element, point.position);
      to.frame.measured_points.push_back({at.position + at.displacement, at.displacement, element, -1, at.stress});
    }
  }

  SolvedStep solved(int step) const {
    const double begin = cpu_seconds();
    SolvedStep result;
    result.step = step;
    const Continuum continuum = continuum_at(step);
    const std::vector<FreePiece> free = free_pieces(continuum);
    if (!free.empty())
      throw NotPositiveDefinite(fmt::format("load step {}: {}{}", step, to_string(free.front()),
                                            free.size() > 1 ? fmt::format(" (and {} more)", free.size() - 1) : ""));
    const ContinuumSolution solution = solve_static(continuum);
    result.seconds = cpu_seconds() - begin;
    result.counts = counts_of(continuum.manifold, solution.basis);
    result.residual = solution.solution.residual;
    result.refinements = solution.solution.refinements;
    result.factor_entries = solution.solution.factor_entries;
    result.balance = balance_of(continuum, solution);
    put_frames(result, continuum, &solution);
    return result;
  }
};

CoverCase::CoverCase(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides) {
  if (!problem.analysis) throw InputError(problem.covers->place, "expected an analysis beside covers, found none");
  Settings settings = settings_of(problem, profile, overrides);
  require_statics(problem, profile, settings);
  parts_ = std::make_unique<Parts>(problem, std::move(settings), overrides);
}

CoverCase::~CoverCase() = default;

const Warnings& CoverCase::warnings() const {
  return parts_->warnings;
}

const CoverCounts& CoverCase::counts() const {
  return parts_->start.counts;
}

const SolvedStep& CoverCase::start() const {
  return parts_->start;
}

void CoverCase::run(const std::function<void(const SolvedStep&)>& on_step) const {
  std::optional<SolvedStep> last;
  for (int step = 1; step <= parts_->load_steps; ++step) {
    if (!last || parts_->bodies.changes_at(step)) last = parts_->solved(step);
    last->step = last->field.step = last->frame.step = step;
    last->time = last->field.time = last->frame.time = step * parts_->settings.time_step;
    on_step(*last);
  }
}

}  // namespace keyblock
