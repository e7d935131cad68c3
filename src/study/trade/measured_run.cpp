// Makes frames only where values are needed, so that steps dominate the measured time.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/trade/measured_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <new>
#include <numeric>
#include <stdexcept>

#include "api/case_folder.hpp"
#include "base/context.hpp"
#include "model/continuum.hpp"
#include "run/run.hpp"
#include "settings/profile.hpp"
#include "study/cases/compared_values.hpp"

namespace keyblock::study {
namespace {

namespace fs = std::filesystem;

constexpr double kLeastTimed = 0.05;  // seconds: shorter ones are mostly the noise of the machine
constexpr int kMostTimings = 1000;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<double> found(const std::vector<ComparedValue>& values) {
  std::vector<double> numbers;
  for (const ComparedValue& v : values) numbers.push_back(v.computed.value_or(std::nan("")));
  return numbers;
}

std::vector<double> displacements(const Frame& frame) {
  std::vector<double> numbers;
  const auto add = [&](Point p) { numbers.insert(numbers.end(), {p.x, p.y}); };
  for (const PointFrame& point : frame.measured_points) add(point.displacement);
  if (numbers.empty())
    for (const ElementFrame& element : frame.elements) add(element.displacement);
  return numbers;
}

// These quantities depend on all steps, not on an instant.
bool needs_every_step(const std::vector<ExpectedValue>& expected) {
  return std::ranges::any_of(expected, [](const ExpectedValue& e) {
    return e.quantity.starts_with("greatest_") || e.quantity == "converged_share";
  });
}

// Returns the largest frame interval that meets every expected time; every step if step sizes vary.
int frame_interval(const std::vector<ExpectedValue>& expected, const Settings& settings) {
  if (needs_every_step(expected)) return 1;
  if (settings.dynamics == Dynamics::shi && settings.step_control == StepControl::shi) return 1;
  int interval = settings.step_count;
  for (const ExpectedValue& e : expected) {
    const double steps = e.time / settings.time_step;
    if (std::abs(steps - std::round(steps)) > kSameInstant || steps > settings.step_count) return 1;
    interval = std::gcd(interval, static_cast<int>(std::round(steps)));
  }
  return interval;
}

/// Values that a run reads as it goes; made anew for each timing.
class Reading {
 public:
  explicit Reading(const StudyCase& chosen) : values_(values_to_find(chosen.expected, "standard")) {}

  void add(const Frame& frame, double time_step) { pick(values_, so_far_, frame, kSameInstant * time_step); }
  void add(const StepReport& report) { so_far_.add(report); }
  std::vector<double> numbers() const { return values_.empty() ? displacements(so_far_.now()) : found(values_); }

 private:
  std::vector<ComparedValue> values_;
  RunSoFar so_far_;
};

void run_scene(const StudyCase& chosen, const Scene& scene, const RunLimits& limits, MeasuredRun& measured) {
  Reading reading(chosen);
  const double begin = cpu_seconds();
  Observer observer;
  observer.on_step = [&](const StepReport& report) { reading.add(report); };
  observer.on_frame = [&](const Frame& frame) { reading.add(frame, scene.settings.time_step); };
  const Context& whole = context();
  const Context limited = whole.part();
  observer.between_steps = [&](const Stepper&) {
    if (cpu_seconds() - begin > limits.cpu_seconds) limited.stop();
  };
  const Under under(limited);
  const RunOutcome outcome = run(scene, frame_interval(chosen.expected, scene.settings), observer);
  measured.seconds = cpu_seconds() - begin;
  measured.steps = outcome.steps;
  if (outcome.end == RunEnd::failed) {
    measured.end = MeasuredEnd::failed;
    measured.reason = outcome.reason;
  } else if (outcome.end == RunEnd::stopped) {
    const bool is_asked = whole.is_stopped();
    const std::string at = fmt::format("at step {} of {}", outcome.steps, scene.settings.step_count);
    measured.end = is_asked ? MeasuredEnd::stopped : MeasuredEnd::over_limit;
    measured.reason =
        is_asked ? "by request " + at : fmt::format("{:.3g} s of processor time reached {}", limits.cpu_seconds, at);
  }
  measured.values = reading.numbers();
}

// Repeats the run until there is enough to measure. The least time counts, because every disturbance lengthens a run.
// An unfinished repetition does not change earlier results.
template <class Run>
void best_of(const RunLimits& limits, MeasuredRun& measured, const Run& run) {
  double sum = 0;
  double best = std::numeric_limits<double>::max();
  do {
    MeasuredRun again = measured;
    try {
      run(again);
    } catch (const StopRequested&) {
      if (measured.timings == 0) throw;
      break;
    }
    if (measured.timings > 0 && again.end != MeasuredEnd::finished) break;
    measured = std::move(again);
    ++measured.timings;
    sum += measured.seconds;
    best = std::min(best, measured.seconds);
  } while (measured.end == MeasuredEnd::finished && measured.timings < kMostTimings && !context().is_stopped() &&
           (measured.timings < limits.repeat || sum < kLeastTimed));
  measured.seconds = best;
}

void require_there(const StudyCase& chosen, const Model& model) {
  require_numbers(values_to_find(chosen.expected, "standard"), model, (chosen.folder / "expected.csv").string());
}

// Elements differ between meshes, so that only points can be compared.
void require_points(const StudyCase& chosen, const Problem& problem, std::size_t points) {
  if (chosen.expected.empty() && points == 0 && problem.covers)
    throw InputError(problem.covers->place,
                     "expected measured points, or expected values to compare with, in a case of NMM bodies");
}

void measure(const StudyCase& chosen, const RunLimits& limits, MeasuredRun& measured) {
  const RunPlan& plan = measured.plan;
  ConfiguredCase made = configured_under(plan.profile, chosen, chosen.input.problem, plan.set);
  const double begin = cpu_seconds();
  MeshByError found = with_mesh_found(made.problem, made.profile.name, made.overrides);
  made.problem = std::move(found.problem);
  const double finding = found.rounds.empty() ? 0 : cpu_seconds() - begin;
  const Prepared prepared = prepared_case(made);
  const Model& model = prepared.scene.model;
  require_there(chosen, model);
  require_points(chosen, made.problem, model.measured_points.size());
  measured.unknowns = prepared.requirements.unknowns;
  // A finer mesh that was requested and not reached is an error here.
  for (const Warning& warning : found.warnings)
    if (warning.name == "mesh_error_not_reached") throw InputError(warning.place, warning.sentence);
  if (finding > limits.cpu_seconds) {
    measured.end = MeasuredEnd::over_limit;
    measured.reason =
        fmt::format("{:.3g} s of processor time, of {:.3g} s, went into its mesh", finding, limits.cpu_seconds);
    measured.seconds = finding;
    return;
  }
  best_of(limits, measured, [&](MeasuredRun& run) { run_scene(chosen, prepared.scene, limits, run); });
  measured.seconds += finding;
}

void tell(MeasuredRun& measured, MeasuredEnd end, const std::string& reason) {
  measured.end = end;
  measured.reason = reason;
}

}  // namespace

StudyCase study_case(const std::vector<std::string>& paths) {
  StudyCase chosen{opened(asked_case({paths, {}, {}, {}})), {}};
  const fs::path table = chosen.folder / "expected.csv";
  if (!chosen.folder.empty() && fs::exists(table)) chosen.expected = read_expected(table.string());
  // The factor of safety belongs to many runs, not to one.
  std::erase_if(chosen.expected, [](const ExpectedValue& value) { return value.quantity == "factor_of_safety"; });
  return chosen;
}

std::string name_of(MeasuredEnd end) {
  constexpr std::array<const char*, 5> kNames{"finished", "failed", "refused", "over limit", "stopped"};
  return kNames.at(static_cast<std::size_t>(end));
}

MeasuredRun measured_run(const StudyCase& chosen, const RunPlan& plan, const RunLimits& limits) {
  MeasuredRun measured;
  measured.plan = plan;
  if (const std::string why = why_not_run(chosen, plan.profile); !why.empty()) {
    tell(measured, MeasuredEnd::refused, why);
    return measured;
  }
  try {
    measure(chosen, limits, measured);
  } catch (const StopRequested& error) {
    tell(measured, MeasuredEnd::stopped, error.what());
  } catch (const InputError& error) {
    if (error.place().file.text() == (chosen.folder / "expected.csv").string()) throw;
    tell(measured, MeasuredEnd::refused, error.what());
  } catch (const std::invalid_argument& error) {
    tell(measured, MeasuredEnd::refused, error.what());
  } catch (const std::bad_alloc&) {
    tell(measured, MeasuredEnd::failed, "there is not enough memory for this");
  } catch (const std::exception& error) {
    tell(measured, MeasuredEnd::failed, error.what());
  }
  return measured;
}

}  // namespace keyblock::study
