// Runs first, then the reference that some of them give, then errors and the front.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/tradeoff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "run/profile.hpp"
#include "study/extrapolation.hpp"

namespace keyblock::study {
namespace {

const MeasuredRun* named(const std::vector<MeasuredRun>& runs, const std::string& name) {
  const auto found = std::ranges::find(runs, name, [](const MeasuredRun& run) { return run.plan.name; });
  return found == runs.end() ? nullptr : &*found;
}

// The cost of the coarser one says enough.
bool is_known_to_be_over(const std::vector<MeasuredRun>& runs, const RunPlan& plan, const RunLimits& limits) {
  const MeasuredRun* coarser = plan.coarser.empty() ? nullptr : named(runs, plan.coarser);
  if (coarser == nullptr) return false;
  return coarser->end == MeasuredEnd::over_limit || coarser->seconds * plan.growth > limits.cpu_seconds;
}

MeasuredRun not_run(const RunPlan& plan, MeasuredEnd end, const std::string& reason) {
  MeasuredRun run;
  run.plan = plan;
  run.end = end;
  run.reason = reason;
  return run;
}

MeasuredRun left_out(const RunPlan& plan, const RunLimits& limits) {
  return not_run(
      plan, MeasuredEnd::over_limit,
      fmt::format("not run: by the cost of {} it would take more than {:.3g} s", plan.coarser, limits.cpu_seconds));
}

bool was_stopped(const MeasuredRun& run) {
  return run.end == MeasuredEnd::stopped;
}

Reference limit_reference(const std::vector<MeasuredRun>& runs, const std::vector<RunPlan>& limit_from) {
  if (limit_from.size() != 3)
    throw std::runtime_error(
        "the case has no step or mesh that could be refined, and no expected values to compare with");
  std::array<std::vector<double>, 3> values;
  for (std::size_t i = 0; i < 3; ++i) {
    const MeasuredRun* run = named(runs, limit_from[i].name);
    if (was_stopped(*run) || run->end == MeasuredEnd::over_limit) {
      Reference none;
      none.words = fmt::format("no errors: {} before the end of \"{}\", which they are measured against",
                               was_stopped(*run) ? "stopped" : "at the limit of a run's time", run->plan.name);
      return none;
    }
    if (run->end != MeasuredEnd::finished)
      throw std::runtime_error(
          fmt::format("no reference: the run \"{}\" {}: {}", run->plan.name, name_of(run->end), run->reason));
    values[i] = run->values;
  }
  const Limit limit = limit_of(values);
  Reference reference;
  reference.values = limit.values;
  reference.uncertainty = limit.uncertainty;
  reference.order = limit.order;
  reference.is_extrapolated = limit.is_extrapolated;
  const std::string names =
      fmt::format("\"{}\", \"{}\" and \"{}\"", limit_from[0].name, limit_from[1].name, limit_from[2].name);
  const std::string order = limit.order ? fmt::format("observed order {:.2f}", *limit.order) : "all three the same";
  reference.words = fmt::format(
      "error: displacements at the end, root mean square over that of the reference, {}; {}, known to {:.1e}",
      limit.is_extrapolated ? fmt::format("extrapolated from the runs {}", names)
                            : fmt::format("the run \"{}\" itself (beside \"{}\", \"{}\")", limit_from[2].name,
                                          limit_from[0].name, limit_from[1].name),
      order, limit.uncertainty);
  if (limit.order && !limit.is_extrapolated)
    reference.words += "; the three do not converge as a method of any order does: errors near that are a guess";
  return reference;
}

}  // namespace

Reference expected_reference(const std::vector<ExpectedValue>& expected, const std::string& rules) {
  const bool some_judged = std::ranges::any_of(expected, [&](const auto& e) { return e.is_judged_in(rules); });
  const auto counts = [&](const ExpectedValue& e) { return !some_judged || e.is_judged_in(rules); };
  const bool all_zero = std::ranges::none_of(expected, [&](const auto& e) { return counts(e) && e.value != 0; });
  Reference reference;
  reference.is_expected = true;
  for (const ExpectedValue& row : expected) {
    double scale = 0;
    for (const ExpectedValue& other : expected)
      if (counts(other) && other.quantity == row.quantity && other.block == row.block)
        scale = std::max(scale, std::abs(other.value));
    reference.values.push_back(row.value);
    reference.scales.push_back(!counts(row) ? 0 : all_zero ? row.tolerance : scale);
  }
  reference.words =
      all_zero ? "error: the greatest over all expected values, which are 0, as a share of their tolerance"
               : "error: the greatest over all expected values, each relative to the greatest expected of that "
                 "quantity and block; values expected to be 0 are left out";
  return reference;
}

double error_of(const MeasuredRun& run, const Reference& reference) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (run.end != MeasuredEnd::finished || run.values.size() != reference.values.size()) return kNone;
  if (!reference.is_expected) {
    const double error = relative_distance(run.values, reference.values);
    return std::isfinite(error) ? error : kNone;
  }
  double greatest = 0;
  for (std::size_t i = 0; i < reference.values.size(); ++i) {
    if (reference.scales[i] == 0) continue;
    const double error = std::abs(run.values[i] - reference.values[i]) / reference.scales[i];
    if (!std::isfinite(error)) return kNone;
    greatest = std::max(greatest, error);
  }
  return greatest;
}

Tradeoff tradeoff(const StudyCase& chosen, const std::vector<RunPlan>& plans, const std::vector<RunPlan>& limit_from,
                  const RunLimits& limits, const OnRun& on_run) {
  Tradeoff result;
  result.name = chosen.name;
  std::vector<RunPlan> all = plans;
  if (chosen.expected.empty())
    for (const RunPlan& plan : limit_from)
      if (std::ranges::find(all, plan.name, &RunPlan::name) == all.end()) all.push_back(plan);
  for (const RunPlan& plan : all) {
    if (limits.wants_stop()) {
      result.runs.push_back(not_run(plan, MeasuredEnd::stopped, "not run"));
      continue;
    }
    const bool is_over = is_known_to_be_over(result.runs, plan, limits);
    result.runs.push_back(is_over ? left_out(plan, limits) : measured_run(chosen, plan, limits));
    on_run(result.runs.back(), result.runs.size(), all.size());
  }
  result.is_stopped = std::ranges::any_of(result.runs, was_stopped);
  result.reference = chosen.expected.empty() ? limit_reference(result.runs, limit_from)
                                             : expected_reference(chosen.expected, "standard");
  const double least = std::max(kLeastError, result.reference.uncertainty);
  for (const MeasuredRun& run : result.runs)
    result.prices.push_back({run.seconds, std::max(least, error_of(run, result.reference))});
  result.front = pareto_front(result.prices);
  return result;
}

}  // namespace keyblock::study
