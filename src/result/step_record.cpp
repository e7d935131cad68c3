// Sums over steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/step_record.hpp"

#include <algorithm>

#include "base/worse.hpp"

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
  greatest_penetration = worse(greatest_penetration, step.greatest_penetration);
  penetration_share = worse(penetration_share, step.penetration_share);
  greatest_displacement_ratio = worse(greatest_displacement_ratio, step.displacement_ratio);
  greatest_residual = worse(greatest_residual, step.residual);
  if (!(step.residual <= kUnbalanced)) ++unbalanced_steps;  // NaN too
  if (!(step.area_share >= area_share)) {                   // NaN too
    area_share = step.area_share;
    crushed_element = step.crushed_element;
  }
  least_dt = std::min(least_dt, step.dt);
  greatest_dt = std::max(greatest_dt, step.dt);
}

}  // namespace keyblock
