// Reports the reason of a failed step and the counts of an accepted one; see step_outcome.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/step_outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/sentences/sentences.hpp"
#include "contact/rows/gap.hpp"
#include "material/elastic.hpp"
#include "step/scene/equilibrium.hpp"

namespace keyblock {
namespace {

constexpr std::size_t kMostNamed = 10;  // contacts in a message; the record lists them all

// A failed step may have no such points.
bool has_points_of(const BodiesMotion& motion, const BodiesMotion& other) {
  return motion.points.blocks.size() == other.points.blocks.size() &&
         motion.points.covers.size() == other.points.covers.size();
}

bool rock_yields(const StandardScene& scene, const BodiesMotion& motion) {
  PlasticTotals totals;
  for (const auto& group : scene.groups) group->add_plastic(motion, totals);
  return totals.yielding > 0;
}

/// Returns the first contacts that did not settle; those beyond the list are of bolts and fixed points.
std::string undecided_in_words(const StandardScene& scene, const StandardStep& step) {
  std::string names;
  std::size_t named = 0;
  for (std::size_t i : step.undecided) {
    if (i >= step.touches.size() || ++named > kMostNamed) continue;
    const Touch& touch = step.touches[i];
    names += fmt::format("{}{} ({} on {})", names.empty() ? "" : ", ", i + 1,
                         part_name(scene, scene.model.vertices[touch.vertex].element),
                         part_name(scene, scene.model.vertices[touch.start].element));
  }
  return named > kMostNamed ? fmt::format("{} and {} more", names, named - kMostNamed) : names;
}

}  // namespace

StepReport report_of(const StandardScene& scene, const Motion& motion, const State& state, const ControlledStep& made) {
  StepReport report;
  report.step = state.step;
  report.time = state.time;
  report.dt = made.least;
  report.passes = made.step.solves;
  report.redos = made.step.halvings;
  report.unresolved_parts = made.unresolved;
  report.fallbacks = made.step.fallbacks;
  report.locked_overlaps = made.step.locked_overlaps;
  report.unsettled_contacts = static_cast<int>(made.step.undecided.size());
  report.closed = static_cast<int>(motion.closed.size());
  report.contacts = std::max(static_cast<int>(made.step.touches.size()), report.closed);  // statics may need no search
  report.matrix_blocks = static_cast<int>(scene.bodies().size());
  report.penalty = scene.has_springs() ? scene.normal_stiffness() : 0;
  report.residual = made.step.residual;
  if (const std::optional<Touch>& worst = made.step.worst) {
    report.residual_element = scene.model.number_of(scene.model.vertices[worst->vertex].element);
    report.residual_other = scene.model.number_of(scene.model.vertices[worst->start].element);
    report.residual_at = state.vertices[worst->vertex];
  }
  report.displacement_ratio = made.displacement / (scene.settings.allowed_displacement_ratio * scene.model.scale);
  for (const auto& [touch, memory] : motion.closed.all()) {
    const double depth = -gap_of(touch, state.vertices);
    const Body& one = scene.bodies()[scene.model.vertices[touch.vertex].element];
    const Body& other = scene.bodies()[scene.model.vertices[touch.start].element];
    report.greatest_penetration = std::max(report.greatest_penetration, depth);
    report.penetration_share = std::max(report.penetration_share, depth / std::min(one.size, other.size));
  }
  return report;
}

StepFailure failure_of(const StandardScene& scene, const Motion& motion, const State& state, const StandardStep& step) {
  const bool yields =
      scene.settings.standard.motion != MotionRule::dynamic &&
      (rock_yields(scene, motion) || (has_points_of(step.motion, motion) && rock_yields(scene, step.motion)));
  const Facts values{{{"step", state.step + 1}, {"time", state.time}}};
  if (!step.failure.empty()) {
    const FailureKind kind = step.turned           ? FailureKind::inside_out
                             : step.moving.empty() ? FailureKind::undecided
                                                   : FailureKind::accelerates;
    StepFailure found = failed("in_step", values, step.failure, kind);
    found.passes = step.solves;
    found.rock_yields = yields;
    found.elements = step.turned ? std::vector{*step.turned} : step.moving;
    return found;
  }
  const bool of_contact = step.end == RoundsEnd::no_contact_forces || !step.touches.empty();
  Facts facts{{{"residual", step.residual}}, {{"end", std::string(in_words(step.end))}}};
  if (const std::string names = undecided_in_words(scene, step); !names.empty())
    facts.texts.emplace_back("undecided", names);
  StepFailure found =
      failed("in_step", values, {of_contact ? "contacts_do_not_settle" : "no_motion_balances", std::move(facts)});
  found.contacts = step.undecided;
  found.passes = step.solves;
  found.rock_yields = yields;
  return found;
}

bool add_crushed_before(const StandardScene& scene, const State& drawn, const State& before, const State& end,
                        Facts& facts) {
  for (ElementIndex e : indices(end.elements)) {
    const double area = end.elements[e].moments.area;
    const std::optional<ElasticLaw> law = scene.groups.of(e).law_of_large_strain(scene.parts(), e);
    if (!std::isfinite(area) || area > 0 || !law) continue;
    facts.numbers.emplace_back("share_before", before.elements[e].moments.area / drawn.elements[e].moments.area);
    if (law != ElasticLaw::st_venant_kirchhoff) return false;
    facts.numbers.emplace_back("softening_stretch", kSofteningStretch);
    return true;
  }
  return false;
}

Finding too_deep(const StandardScene& scene, const Motion& motion, const State& end) {
  for (const auto& [touch, memory] : motion.closed.all()) {
    const ElementIndex vertex = scene.model.vertices[touch.vertex].element;
    const ElementIndex edge = scene.model.vertices[touch.start].element;
    if (scene.groups.of(vertex).resolves_impacts() || scene.groups.of(edge).resolves_impacts()) continue;
    const double size = std::min(scene.bodies()[vertex].size, scene.bodies()[edge].size);
    const double depth = -gap_of(touch, end.vertices) - memory.compression;
    const double limit = scene.settings.trust.penetration;
    if (!(depth > limit * size)) continue;
    return {"blocks_overlap_deeply",
            {{{"depth", depth}, {"share", depth / size}, {"limit", limit}},
             {{"one", part_name(scene, vertex)}, {"two", part_name(scene, edge)}},
             {scene.model.number_of(vertex), scene.model.number_of(edge)},
             {{{end.vertices[touch.vertex].x, end.vertices[touch.vertex].y}}}}};
  }
  return {};
}

}  // namespace keyblock
