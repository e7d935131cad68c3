// Goes once through all elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/extremes.hpp"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

double greatest_displacement(const ElementFrame& before, const ElementFrame& after) {
  double greatest = 0;
  for (std::size_t l = 0; l < before.loops.size(); ++l)
    for (std::size_t v = 0; v < before.loops[l].size(); ++v)
      greatest = std::max(greatest, length(after.loops[l][v] - before.loops[l][v]));
  return greatest;
}

}  // namespace

std::pair<double, double> principal(const Stress& stress) {
  const double mean = (stress.xx + stress.yy) / 2;
  const double radius = std::hypot((stress.xx - stress.yy) / 2, stress.xy);
  return {mean - radius, mean + radius};
}

Extremes extremes_of(const Frame& start, const Frame& end) {
  Extremes found;
  for (std::size_t e = 0; e < end.elements.size(); ++e) {
    const int index = static_cast<int>(e);
    const double displacement = greatest_displacement(start.elements[e], end.elements[e]);
    const auto [least, greatest] = principal(end.elements[e].stress);
    if (displacement > found.displacement) {
      found.displacement = displacement;
      found.displaced_element = index;
    }
    const double area_share = end.elements[e].area / start.elements[e].area;
    if (area_share < found.area_share) {
      found.area_share = area_share;
      found.crushed_element = index;
    }
    if (e == 0 || least < found.least_stress) {
      found.least_stress = least;
      found.compressed_element = index;
    }
    if (e == 0 || greatest > found.greatest_stress) {
      found.greatest_stress = greatest;
      found.stretched_element = index;
    }
  }
  return found;
}

}  // namespace keyblock
