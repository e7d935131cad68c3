// Sums over steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/step_record.hpp"

#include <algorithm>

namespace keyblock {

void StepTotals::add(const StepReport& step) {
  ++steps;
  most_contacts = std::max(most_contacts, step.contacts);
  redos += step.redos;
  fallbacks += step.fallbacks;
  passes += static_cast<std::size_t>(step.passes);
  most_passes = std::max(most_passes, step.passes);
  const auto bin = std::ranges::lower_bound(pass_limits, step.passes) - pass_limits.begin();
  ++steps_by_passes[static_cast<std::size_t>(bin)];
  unresolved_parts += step.unresolved_parts;
  locked_overlaps += step.locked_overlaps;
  greatest_penetration = std::max(greatest_penetration, step.greatest_penetration);
  penetration_share = std::max(penetration_share, step.penetration_share);
  greatest_displacement_ratio = std::max(greatest_displacement_ratio, step.displacement_ratio);
  greatest_residual = std::max(greatest_residual, step.residual);
  least_dt = std::min(least_dt, step.dt);
  greatest_dt = std::max(greatest_dt, step.dt);
}

}  // namespace keyblock
