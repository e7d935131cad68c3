// Solves for equilibria at one load fraction after another; see static_shares.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/static_shares.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "step/rest/static_step.hpp"
#include "step/scene/equilibrium.hpp"

namespace keyblock {
namespace {

// Number of load increments in further searches for a first equilibrium of NMM bodies.
constexpr std::array kFinerShares{5, 20};
constexpr int kMost = tolerances::of_statics::kMostIterations;

StandardStep unchanged(const StandardScene& scene, const Motion& motion, double time) {
  StandardStep step;
  step.motion = motion;
  step.residual = balance_of(scene, motion, time).share;
  return step;
}

// Returns the later of two equilibria of one step, with the work of both.
StandardStep joined(const StandardStep& earlier, StandardStep later) {
  later.account += earlier.account;
  later.solves += earlier.solves;
  later.fallbacks += earlier.fallbacks;
  later.halvings += earlier.halvings;
  later.locked_overlaps += earlier.locked_overlaps;
  return later;
}

// A search for the first equilibrium of soft bodies may fail under the whole load and succeed in increments.
StandardStep in_finer_shares(StandardScene& scene, const Motion& motion, StandardStep made, double time,
                             int most_iterations) {
  for (const int count : kFinerShares) {
    if (made.converged && made.failure.empty()) return made;
    StandardStep parts;
    parts.motion = motion;
    parts.converged = true;
    for (int share = 1; share <= count && parts.converged && parts.failure.empty(); ++share) {
      scene.load_share = static_cast<double>(share) / count;
      parts = joined(parts, static_step(scene, parts.motion, time, most_iterations));
    }
    scene.load_share = 1;
    if (parts.converged && parts.failure.empty()) made = std::move(parts);
  }
  return made;
}

}  // namespace

StandardStep first_equilibrium(StandardScene& scene, const Motion& motion, double time, int most_iterations) {
  StandardStep made = static_step(scene, motion, time, most_iterations);
  return scene.is_linear() ? made : in_finer_shares(scene, motion, std::move(made), time, most_iterations);
}

StandardStep static_equilibrium(StandardScene& scene, const Motion& motion, const LoadStep& step) {
  const UnknownsTable last = loads_at(scene, motion.q, step.from);
  const auto stays = [&](const HeldPair& pair) { return pair.is_same_at(step.from, step.to); };
  const int wanted = scene.settings.standard.load_steps;
  const int growing = std::min(wanted, scene.settings.step_count);  // number of steps
  const auto shares_after = [&](int steps) {
    return static_cast<int>(std::int64_t{wanted} * std::min(steps, growing) / growing);
  };
  const int end = shares_after(step.made + 1);
  int share = std::min(shares_after(step.made) + 1, end);
  scene.load_share = static_cast<double>(share) / wanted;
  if (step.made > 0 && !step.is_new && last == loads_at(scene, motion.q, step.to) &&
      std::ranges::all_of(scene.held, stays))
    return unchanged(scene, motion, step.to);
  const bool is_whole = step.made == 0 && wanted == 1;
  StandardStep made =
      is_whole ? first_equilibrium(scene, motion, step.to, kMost) : static_step(scene, motion, step.to, kMost);
  while (++share <= end && made.converged && made.failure.empty()) {
    scene.load_share = static_cast<double>(share) / wanted;
    made = joined(made, static_step(scene, made.motion, step.to, kMost));
  }
  return made;
}

}  // namespace keyblock
