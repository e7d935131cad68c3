// Runs one scene after another, spread over threads by scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/validate/convergence.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <ctime>
#include <thread>

#include "run/run.hpp"
#include "tests/validate/motion_watch.hpp"

namespace keyblock {
namespace {

constexpr std::array<const char*, 2> kProfiles{"legacy", "standard"};
// A step shorter than requested by less than this fraction counts as the requested one: the round-off of a division by
// a ratio of one.
constexpr double kSameStep = 1e-9;

void count_step(SceneRun& counts, const StepReport& step) {
  ++counts.made;
  counts.passes += step.passes;
  counts.residuals.push_back(step.residual);
  if (step.unsettled_contacts > 0) ++counts.unsettled;
  if (step.redos > 0) ++counts.cut_here;
  if (step.redos > 0 || step.dt < (1 - kSameStep) * counts.time_step)
    ++counts.cut;
  else if (step.fallbacks > 0)
    ++counts.with_fallback;
  else
    ++counts.plain;
}

// Processor time of the thread.
double seconds_used() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void run_prepared(const Scene& scene, SceneRun& counts) {
  counts.blocks = static_cast<int>(scene.model.elements.size());
  MotionWatch watch(scene.model, scene.settings);
  Observer observer;
  observer.on_frame = [&](const Frame& frame) { watch.see(frame); };
  observer.on_step = [&](const StepReport& step) { count_step(counts, step); };
  const RunOutcome outcome = run(scene, 1, observer);
  if (outcome.end != RunEnd::finished) counts.end = End::failed;
  counts.reason = outcome.reason;
  counts.energy_excess = watch.greatest_excess();
  counts.energy_gain = watch.greatest_gain();
  counts.energy_ratio = watch.greatest_ratio();
  counts.rise = watch.greatest_rise();
  counts.area_change = watch.greatest_area_change();
  counts.overlap = watch.greatest_overlap();
  counts.false_area_change = watch.greatest_false_area_change();
  counts.all_finite = watch.all_finite();
}

}  // namespace

std::vector<Override> constant_step() {
  return {{"step_control", "constant"}};
}

SceneRun run_scene(const RandomScene& scene, const std::string& profile, const std::vector<Override>& overrides) {
  SceneRun counts;
  counts.scene = scene.name;
  counts.profile = profile;
  counts.time_step = scene.problem.analysis->time_step;
  counts.asked = scene.problem.analysis->step_count;
  const double begin = seconds_used();
  try {
    run_prepared(prepare(scene.problem, profile, overrides).scene, counts);
  } catch (const InputError& refusal) {
    counts.end = End::refused;
    counts.reason = refusal.sentence();
  } catch (const std::exception& error) {
    counts.end = End::crashed;
    counts.reason = error.what();
  }
  counts.seconds = seconds_used() - begin;
  return counts;
}

std::vector<SceneRun> run_scenes(std::uint64_t first, int count, int threads, int steps) {
  std::vector<SceneRun> runs(kProfiles.size() * static_cast<std::size_t>(count));
  std::atomic<int> next = 0;
  const auto work = [&] {
    for (int i = next++; i < count; i = next++) {
      RandomScene scene = random_scene(first + static_cast<std::uint64_t>(i));
      if (steps > 0) scene.problem.analysis->step_count = steps;
      for (std::size_t p = 0; p < kProfiles.size(); ++p)
        runs[kProfiles.size() * static_cast<std::size_t>(i) + p] = run_scene(scene, kProfiles[p], constant_step());
    }
  };
  std::vector<std::thread> pool;
  for (int i = 0; i < threads; ++i) pool.emplace_back(work);
  for (std::thread& thread : pool) thread.join();
  return runs;
}

}  // namespace keyblock
