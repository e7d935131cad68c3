// Holds the plastic state of elastoplastic rock at a point and in total, for frames and histories.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "material/yield_law.hpp"

namespace keyblock {

/// State of a point. Plastic strain since the start, tensor components (xy is half of the shear angle) along the axes
/// of the plane, extension positive. It rotates with the body.
struct PlasticState {
  double xx = 0;
  double yy = 0;
  double xy = 0;
  double zz = 0;
  double equivalent = 0;                      ///< κ = ∫ √(2/3) ‖dev dεᵖ‖; grows under reversed flow too
  YieldRegion region = YieldRegion::elastic;  ///< at the end of the last step
  bool has_yielded = false;                   ///< since the start; for a mean of points: at least half of them have

  bool operator==(const PlasticState&) const = default;
};

/// Returns true if a point has yielded since the start.
bool has_yielded(const YieldState& memory);

/// Returns a memory in the axes of the plane, for a body rotated by `angle` [rad, counter-clockwise].
PlasticState plastic_state(const YieldState& memory, double angle);

/// Totals of all rock that may yield; areas at the start, length².
struct PlasticTotals {
  double area = 0;
  double yielded = 0;               ///< area that has yielded since the start
  double yielding = 0;              ///< area that ended the last step on its yield surface
  std::optional<double> work = {};  ///< ∫ σ · dεᵖ since the start, per unit thickness; empty if it is not summed

  void add(double of, const YieldState& memory);
  double yielded_fraction() const { return area > 0 ? yielded / area : 0; }
  double yielding_fraction() const { return area > 0 ? yielding / area : 0; }
};

}  // namespace keyblock
