// Implements the two rotation rules.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/motion.hpp"

#include <cmath>

#include "base/worse.hpp"

namespace keyblock {
namespace {

Point exact_displacement(const Basis& basis, const Unknowns& increment, Point offset) {
  if (basis.rotation_unknown < 0) return basis.displacement(increment, offset);
  Unknowns without_rotation = increment;
  without_rotation[basis.rotation_unknown] = 0;
  const double r = increment[basis.rotation_unknown];
  const double c = std::cos(r) - 1;
  const double s = std::sin(r);
  return basis.displacement(without_rotation, offset) + Point{offset.x * c - offset.y * s, offset.x * s + offset.y * c};
}

}  // namespace

Point displacement(const Basis& basis, const Unknowns& increment, Point offset, Rotation rotation) {
  return rotation == Rotation::exact ? exact_displacement(basis, increment, offset)
                                     : basis.displacement(increment, offset);
}

FarthestElement farthest_element(const Model& model, const State& state, const Increments& increments,
                                 Rotation rotation) {
  FarthestElement farthest;
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    for (VertexIndex v : element.vertices()) {
      const Point offset = state.vertices[v] - state.elements[e].centroid;
      const double way = length(displacement(*element.basis, increments[e], offset, rotation));
      const double greatest = worse(farthest.displacement, way);
      if (greatest == farthest.displacement || std::isnan(farthest.displacement)) continue;
      farthest = {e, greatest};
    }
  }
  return farthest;
}

}  // namespace keyblock
