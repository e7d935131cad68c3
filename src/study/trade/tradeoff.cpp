// Makes the runs first, then the reference from some of them, then errors and the front.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/trade/tradeoff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/context.hpp"
#include "settings/profile.hpp"
#include "study/trade/extrapolation.hpp"

namespace keyblock::study {
namespace {

const MeasuredRun* named(const std::vector<MeasuredRun>& runs, const std::string& name) {
  const auto found = std::ranges::find(runs, name, [](const MeasuredRun& run) { return run.plan.name; });
  return found == runs.end() ? nullptr : &*found;
}

// The cost of the coarser run decides.
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
  if (limit_from.size() < 3)
    throw std::runtime_error(
        "the case has no step or mesh that could be refined, and no expected values to compare with");
  const std::size_t first = limit_from.size() - 3;
  std::array<std::vector<double>, 3> values;
  for (std::size_t i = 0; i < 3; ++i) {
    const MeasuredRun* run = named(runs, limit_from[first + i].name);
    if (was_stopped(*run) || run->end == MeasuredEnd::over_limit) {
      Reference none;
      none.words = "no errors";
      none.doubt = fmt::format("{} before the end of \"{}\", which errors are measured against",
                               was_stopped(*run) ? "stopped" : "at the limit of a run's time", run->plan.name);
      return none;
    }
    if (run->end != MeasuredEnd::finished)
      throw std::runtime_error(
          fmt::format("no reference: the run \"{}\" {}: {}", run->plan.name, name_of(run->end), run->reason));
    values[i] = run->values;
  }
  const bool is_of_steps =
      std::ranges::any_of(limit_from.back().set, [](const Override& setting) { return setting.first == "time_step"; });
  const Limit limit = limit_of(values, is_of_steps ? Refined::step : Refined::mesh);
  Reference reference;
  reference.values = limit.values;
  reference.uncertainty = limit.uncertainty;
  reference.order = limit.order;
  reference.is_extrapolated = limit.is_extrapolated;
  if (!limit.is_extrapolated && limit.order)
    reference.doubt = "the three runs do not converge as a method of any order does";
  const std::array<std::string, 3> names{limit_from[first].name, limit_from[first + 1].name,
                                         limit_from[first + 2].name};
  const std::string order = limit.order ? fmt::format("observed order {:.2f}", *limit.order) : "all three the same";
  reference.words = fmt::format(
      "error: displacements at the end, root mean square over that of the reference, {}; {}, known to {:.1e}",
      limit.is_extrapolated
          ? fmt::format("extrapolated from the runs \"{}\", \"{}\" and \"{}\"", names[0], names[1], names[2])
          : fmt::format("the run \"{}\" itself (besides \"{}\", \"{}\")", names[2], names[0], names[1]),
      order, limit.uncertainty);
  return reference;
}

// Uncertainty of a resolved limit, unless a smaller one is requested.
constexpr double kResolved = 1e-2;
// Errors of this many times the uncertainty u of the limit are known within a factor of three: (e + u) / (e - u).
constexpr double kToldApart = 2;
constexpr int kFinestOfAll = 1024;  // part of the step
// Number of successive halvings without a better limit after which more would not help.
constexpr int kMostInVain = 2;
constexpr int kMostRounds = 8;
constexpr int kMostAtOnce = 8;        // largest division of a run at a time
constexpr std::size_t kFamilies = 3;  // kinds of runs refined for a target

/// Runs of a study as they accumulate.
class Study {
 public:
  Study(const StudyCase& chosen, const RunLimits& limits, const OnRun& on_run, const Search& search)
      : chosen_(chosen), limits_(limits), on_run_(on_run), search_(search) {
    result_.name = chosen.name;
  }

  void run_all(const std::vector<RunPlan>& plans, const std::vector<RunPlan>& limit_from) {
    std::vector<RunPlan> all = plans;
    if (is_limit()) {
      series_ = limit_from;
      for (const RunPlan& plan : limit_from)
        if (std::ranges::find(all, plan.name, &RunPlan::name) == all.end()) all.push_back(plan);
    }
    planned_ = all.size();
    for (const RunPlan& plan : all) add(plan);
    judge();
  }

  void search() {
    if (!search_.refine) return;
    if (is_limit()) resolve(search_.wish.error ? *search_.wish.error / (1 + kToldApart) : kResolved);
    for (int round = 0; round < kMostRounds && !is_stopped(); ++round) {
      const bool is_new = go_nearer();
      const auto choice = choice_for(result_.prices, search_.wish);
      const bool is_told_apart =
          !is_limit() || !choice ||
          resolve((result_.prices[*choice].error - result_.reference.uncertainty) / kToldApart) == 0;
      if (!is_new && is_told_apart) return;
    }
  }

  Tradeoff take() { return std::move(result_); }

 private:
  bool is_limit() const { return chosen_.expected.empty(); }
  bool is_stopped() const { return std::ranges::any_of(result_.runs, was_stopped); }

  void add(const RunPlan& plan) {
    if (context().is_stopped()) {
      result_.runs.push_back(not_run(plan, MeasuredEnd::stopped, "not run"));
      return;
    }
    const bool is_over = is_known_to_be_over(result_.runs, plan, limits_);
    result_.runs.push_back(is_over ? left_out(plan, limits_) : measured_run(chosen_, plan, limits_));
    planned_ = std::max(planned_, result_.runs.size());
    on_run_(result_.runs.back(), result_.runs.size(), planned_);
  }

  void judge() {
    result_.is_stopped = is_stopped();
    result_.reference =
        is_limit() ? limit_reference(result_.runs, series_) : expected_reference(chosen_.expected, "standard");
    say_where_not_resolved();
    result_.prices.clear();
    for (const MeasuredRun& run : result_.runs)
      result_.prices.push_back(
          {run.seconds, std::max(kLeastError, error_of(run, result_.reference) + result_.reference.uncertainty)});
    result_.front = pareto_front(result_.prices);
  }

  // Halves the step of the limit until it is known to `goal`; returns the number of halvings.
  int resolve(double goal) {
    int halvings = 0;
    int in_vain = 0;
    while (!is_stopped() && !result_.reference.values.empty() && !is_known_to(goal) && in_vain < kMostInVain) {
      const double before = result_.reference.uncertainty;
      if (!halve()) break;
      in_vain = result_.reference.uncertainty < before ? 0 : in_vain + 1;
      ++halvings;
    }
    why_no_nearer_ =
        in_vain >= kMostInVain ? "halves of the step bring it no nearer" : "a finer run would take more than a run may";
    say_where_not_resolved();
    return halvings;
  }

  void say_where_not_resolved() {
    Reference& reference = result_.reference;
    if (reference.doubt.empty() && !why_no_nearer_.empty() && reference.uncertainty > kResolved)
      reference.doubt = why_no_nearer_;
  }

  bool is_known_to(double goal) const {
    return result_.reference.is_resolved() && result_.reference.uncertainty <= std::max(goal, kLeastError);
  }

  bool halve() {
    const MeasuredRun* finest = named(result_.runs, series_.back().name);
    const auto plan = finest->seconds * 2 > limits_.cpu_seconds ? std::nullopt : halved_limit();
    if (!plan) return false;
    if (named(result_.runs, plan->name) == nullptr) add(*plan);
    if (named(result_.runs, plan->name)->end != MeasuredEnd::finished) {
      judge();
      return false;
    }
    series_.push_back(*plan);
    judge();
    return true;
  }

  std::optional<RunPlan> halved_limit() const {
    const RunPlan& finest = series_.back();
    const auto plan = search_.refine(finest, 2);
    const MeasuredRun* own = named(result_.runs, series_.front().name);
    const bool is_too_fine = series_.size() > 3 && named(result_.runs, finest.name)->steps > kFinestOfAll * own->steps;
    return is_too_fine ? std::nullopt : plan;
  }

  // Refines the runs most promising for the target; returns false if nothing is left to do.
  bool go_nearer() {
    const auto choice = choice_for(result_.prices, search_.wish);
    const bool is_met = search_.wish.error && choice;
    if (is_met || (!search_.wish.error && !search_.wish.budget)) return false;
    bool is_new = false;
    for (const std::size_t which : most_promising())
      if (const auto plan = finer(which)) {
        add(*plan);
        is_new = true;
      }
    if (is_new) judge();
    return is_new;
  }

  double time() const { return std::min(limits_.cpu_seconds, search_.wish.budget.value_or(limits_.cpu_seconds)); }

  // Ranks runs by the error that refinement within the time would reach, at the order of the limit.
  std::vector<std::size_t> most_promising() const {
    const double order = std::clamp(result_.reference.order.value_or(1), 1.0, 2.0);
    std::vector<std::size_t> runs;
    for (std::size_t i = 0; i < result_.runs.size(); ++i)
      if (std::isfinite(result_.prices[i].error) && 2 * result_.prices[i].seconds <= time()) runs.push_back(i);
    const auto promise = [&](std::size_t i) {
      return error_of(result_.runs[i], result_.reference) * std::pow(result_.prices[i].seconds / time(), order);
    };
    std::ranges::stable_sort(runs, {}, promise);
    if (runs.size() > kFamilies) runs.resize(kFamilies);
    return runs;
  }

  // Returns the run divided as far as time and target error require; empty if that has been run.
  std::optional<RunPlan> finer(std::size_t which) const {
    const double order = std::clamp(result_.reference.order.value_or(1), 1.0, 2.0);
    const double error = error_of(result_.runs[which], result_.reference);
    if (error <= kLeastError) return std::nullopt;
    for (int parts = kMostAtOnce; parts > 1; parts /= 2) {
      if (result_.prices[which].seconds * parts > time()) continue;
      const bool is_more_than_asked =
          search_.wish.error && error / std::pow(parts / 2, order) < *search_.wish.error / (1 + kToldApart);
      if (is_more_than_asked && parts > 2) continue;
      const auto plan = search_.refine(result_.runs[which].plan, parts);
      if (plan && named(result_.runs, plan->name) == nullptr) return plan;
    }
    return std::nullopt;
  }

  const StudyCase& chosen_;
  const RunLimits& limits_;
  const OnRun& on_run_;
  const Search& search_;
  std::vector<RunPlan> series_;  ///< the limit is taken from its last three
  std::size_t planned_ = 0;
  std::string why_no_nearer_;  ///< at the last attempt to resolve the limit
  Tradeoff result_;
};

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

// The uncertainty assumes converging runs. Without them an error ten times as large is possible.
double Reference::guessed_below() const {
  constexpr double kMargin = 10;
  return is_resolved() ? 0 : kMargin * uncertainty;
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
                  const RunLimits& limits, const OnRun& on_run, const Search& search) {
  Study study(chosen, limits, on_run, search);
  study.run_all(plans, limit_from);
  study.search();
  return study.take();
}

}  // namespace keyblock::study
