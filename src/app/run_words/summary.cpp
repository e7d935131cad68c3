// Formats values from the record of the run as words.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_words/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/progress.hpp"
#include "base/counted.hpp"
#include "base/words/plain_number.hpp"
#include "geometry/box.hpp"
#include "job/run_doubts.hpp"
#include "job/verdict/end_of_motion.hpp"
#include "problem/units/readable.hpp"

namespace keyblock {
namespace {

using Rows = std::vector<std::string>;

constexpr double kShortTime = 10;     // seconds; shorter times have a decimal
constexpr double kRoundOff = 1e-9;    // of the largest stress
constexpr double kNoOverlap = 1e-12;  // of the size of the scene

void put(Rows& rows, std::string_view name, const std::string& words) {
  rows.push_back(fmt::format("  {:9} {}", name, words));
}

std::string element_in_words(const Prepared& prepared, int number) {
  return fmt::format("{} {}", prepared.scene.model.nodes.empty() ? "block" : "element", number + 1);
}

// Returns the force of the largest stress at the end over the extent of the bodies.
double force_of_stress(const FieldFrame& field) {
  Box box;
  double greatest = 0;
  for (const FieldElement& element : field.elements)
    for (const std::vector<FieldCorner>& loop : element.loops)
      for (const FieldCorner& corner : loop) {
        box.add(corner.position);
        greatest =
            std::max({greatest, std::abs(corner.stress.xx), std::abs(corner.stress.yy), std::abs(corner.stress.xy)});
      }
  return field.elements.empty() ? 0 : greatest * length(box.size());
}

// Resultants below this fraction of `force_of_stress` belong to loads that balance each other.
constexpr double kNoResultant = 1e-6;

bool are_loaded(const ForceBalance& forces) {
  return length(forces.loads.force) != 0 || forces.loads.moment != 0;
}

std::string balance_in_words(const ForceBalance& forces, const FieldFrame& field) {
  double largest = length(forces.loads.force);
  for (const Resultant& support : forces.supports) largest = std::max(largest, length(support.force));
  if (largest <= kNoResultant * force_of_stress(field))
    return "the applied loads balance each other; the supports carry nothing";
  return fmt::format("loads and reactions agree to {:.1g} of the largest", forces.unbalanced());
}

void put_stages(Rows& rows, const RunRecord& record) {
  const std::vector<SceneReport>& stages = record.outcome.scenes;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const SceneReport& stage = stages[i];
    if (stage.last_step == stage.first_step) continue;  // stopped before its first step
    put(rows, fmt::format("stage {}", i + 1),
        fmt::format("{}steps {} to {}, t = {}{}", stage.name.empty() ? "" : stage.name + ": ", stage.first_step + 1,
                    stage.last_step, readable(stage.end_time, measures::kTime, record.units),
                    stage.is_balanced ? ", balanced" : ""));
  }
}

void put_stresses(Rows& rows, const Prepared& prepared, const RunRecord& record) {
  const Extremes& found = record.extremes;
  const double largest = std::max(std::abs(found.least_stress), std::abs(found.greatest_stress));
  const auto value = [&](double stress, int number) {
    if (std::abs(stress) <= kRoundOff * largest) stress = 0;
    return fmt::format("{}{} ({})", stress > 0 ? "+" : "", readable(stress, measures::kStress, record.units),
                       element_in_words(prepared, number));
  };
  if (largest == 0) return;
  put(rows, "stress",
      fmt::format("{} to {}, tension positive", value(found.least_stress, found.compressed_element),
                  value(found.greatest_stress, found.stretched_element)));
}

void put_contacts(Rows& rows, const Prepared& prepared, const RunRecord& record) {
  const StepReport* last = record.steps.last();
  if (last == nullptr || record.totals.most_contacts == 0) return;
  const double depth = record.totals.greatest_penetration;
  put(rows, "contacts",
      fmt::format("{}, of which {} closed; {}", last->contacts, last->closed,
                  depth > kNoOverlap * prepared.scene.model.scale
                      ? "deepest overlap " + readable(depth, measures::kLength, record.units)
                      : "no overlap"));
}

void put_energy(Rows& rows, const RunRecord& record) {
  if (!keeps_energy(record)) return;
  const LedgerScope& scope = record.outcome.ledger_scope;
  const double made = record.energy_created;
  const std::string created =
      made > 0 ? fmt::format("energy created: {:.2g} of the largest", made) : "energy created: none";
  put(rows, "energy",
      scope.has_flows ? fmt::format("balance closes to {:.1g}; {}", record.ledger_sums.energy_closure(), created)
                      : created);
}

std::string reaction_in_words(const ReactionCurve& curve, const Units& units) {
  const bool has_unit = is_declared(measures::kForce, units);
  return fmt::format("reaction {} of displacement {} is {}{}{}", curve.component, curve.number + 1,
                     plain(curve.reaction.back(), 6), has_unit ? " " : "",
                     has_unit ? unit_of(measures::kForce, units) : std::string());
}

void put_limit_loads(Rows& rows, const RunRecord& record) {
  const bool has_yielded = record.plastic && record.plastic->totals.yielded > 0;
  for (const ReactionCurve& curve : record.reactions) {
    const std::string reaction = reaction_in_words(curve, record.units);
    const auto driven = [&](std::size_t i) { return readable(curve.driven[i], measures::kLength, record.units); };
    if (const std::optional<std::size_t> first = plateau_of(curve))
      put(rows, "limit",
          fmt::format("limit load of this mesh: {} since step {}, driven by {}", reaction, curve.steps[*first],
                      driven(*first)));
    else if (const std::optional<double> slope = end_slope(curve); slope && has_yielded)
      put(rows, "limit",
          fmt::format("not reached: {}, driven by {}; it still {} by {:.2g} % per % of displacement", reaction,
                      driven(curve.driven.size() - 1), *slope < 0 ? "falls" : "grows", std::abs(*slope)));
  }
}

void put_yielding(Rows& rows, const RunRecord& record) {
  if (record.plastic && record.plastic->totals.yielded == 0)
    put(rows, "yielded", "no rock has yielded");
  else if (record.plastic)
    put(rows, "yielded",
        fmt::format("{:.3g} % of the elastoplastic rock; equivalent plastic strain up to {:.3g} (element {})",
                    100 * record.plastic->totals.yielded_fraction(), record.plastic->equivalent,
                    record.plastic->element + 1));
  put_limit_loads(rows, record);
}

std::string seconds_in_words(double seconds) {
  return seconds < kShortTime ? fmt::format("{:.1f} s", seconds) : time_in_words(seconds);
}

}  // namespace

std::string end_in_words(const RunRecord& record) {
  const RunOutcome& outcome = record.outcome;
  const Timings& timings = record.timings;
  const char* const end = outcome.end == RunEnd::finished ? "finished"
                          : outcome.end == RunEnd::failed ? "failed"
                                                          : "stopped";
  return fmt::format("{} in {}: {}, t = {}", end, seconds_in_words(timings.read + timings.prepare + timings.run),
                     counted(static_cast<std::size_t>(outcome.steps), "step"),
                     readable(outcome.time, measures::kTime, record.units));
}

std::vector<std::string> summary_rows(const Prepared& prepared, const RunRecord& record) {
  Rows rows;
  if (record.outcome.steps == 0) return rows;
  put_stages(rows, record);
  if (record.motion) {
    put(rows, "motion", state_in_words(prepared, record, *record.motion));
    put(rows, "largest", farthest_in_words(prepared, record, *record.motion));
  }
  put_stresses(rows, prepared, record);
  put_contacts(rows, prepared, record);
  if (record.outcome.forces && are_loaded(*record.outcome.forces))
    put(rows, "forces", balance_in_words(*record.outcome.forces, record.outcome.field));
  put_yielding(rows, record);
  put_energy(rows, record);
  if (!record.outcome.why_early.empty())
    put(rows, "ended", fmt::format("before step {}: {}", record.outcome.steps + 1, record.outcome.why_early));
  return rows;
}

std::string solver_in_words(const Settings& settings, const StepTotals& totals) {
  std::string words = fmt::format(
      "solver: {:.3g} {} per step on average, {} at most", static_cast<double>(totals.passes) / totals.steps,
      settings.dynamics == Dynamics::shi ? "open-close iterations" : "linear solves", totals.most_passes);
  for (std::size_t i = 0; i < totals.steps_by_passes.size(); ++i) {
    if (totals.steps_by_passes[i] == 0) continue;
    const bool is_last = i == StepTotals::pass_limits.size();
    const std::string bin =
        i == 0    ? "0"
        : is_last ? fmt::format("over {}", StepTotals::pass_limits.back())
                  : fmt::format("{} to {}", StepTotals::pass_limits[i - 1] + 1, StepTotals::pass_limits[i]);
    words += fmt::format("; {} in {}", bin, counted(static_cast<std::size_t>(totals.steps_by_passes[i]), "step"));
  }
  return words;
}

}  // namespace keyblock
