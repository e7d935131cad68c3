// What rock that may yield has gone through, at a point and in all: what frames and histories report of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "material/yield_law.hpp"

namespace keyblock {

/// Of a point. Plastic strain since the start, components of the tensor (xy is half of the shear angle) along the axes
/// of the plane, extension positive; in bodies that turn it is turned with them.
struct PlasticState {
  double xx = 0;
  double yy = 0;
  double xy = 0;
  double zz = 0;
  double equivalent = 0;  ///< κ = ∫ √(2/3) ‖dev dεᵖ‖, which grows under reversed flow too
  YieldRegion region = YieldRegion::elastic;  ///< where the last step ended
  bool has_yielded = false;                   ///< since the start; of a mean of points at least half of them

  bool operator==(const PlasticState&) const = default;
};

/// Whether a point has, since the start.
bool has_yielded(const YieldState& memory);

/// A memory in the axes of a body that is turned by `angle` (rad, counter-clockwise).
PlasticState plastic_state(const YieldState& memory, double angle);

/// Of all rock that may yield; areas at the start, length².
struct PlasticTotals {
  double area = 0;
  double yielded = 0;               ///< area of what has yielded since the start
  double yielding = 0;              ///< area of what ended the last step on its surface
  std::optional<double> work = {};  ///< ∫ σ · dεᵖ since the start, per unit thickness; none where it is not summed

  void add(double of, const YieldState& memory);
  double yielded_fraction() const { return area > 0 ? yielded / area : 0; }
  double yielding_fraction() const { return area > 0 ? yielding / area : 0; }
};

}  // namespace keyblock
