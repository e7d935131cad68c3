// Where bodies on covers lie once their displacement at rest is known.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "model/scene/scene.hpp"
#include "model/state.hpp"

namespace keyblock {

/// The field of a static solution, at the point of an element that lay at X.
struct StaticField {
  std::function<Point(ElementIndex e, Point start)> place;
  std::function<Stress(ElementIndex e, Point start)> stress;
};

/// Puts places, stresses and measured points of a field into a state.
void put_places(const Scene& scene, const StaticField& field, State& state);

}  // namespace keyblock
