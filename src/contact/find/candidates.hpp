// Finds pairs of elements close enough for contact, from their bounding boxes. Theory:
// docs/theory/04-contact-geometry.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/box.hpp"
#include "model/state.hpp"

namespace keyblock {

struct ElementPair {
  ElementIndex lower;
  ElementIndex upper;

  auto operator<=>(const ElementPair&) const = default;
};

/// Returns the bounding box of an element's current vertices.
Box box_of(const Model& model, const State& state, ElementIndex element);

/// Returns true if the boxes overlap when one is grown by `distance`.
bool touch(const Box& a, const Box& b, double distance);

/// Returns, in ascending order, the pairs whose bounding boxes overlap when one is grown by `distance`. The order does
/// not depend on the search.
std::vector<ElementPair> close_pairs(const Model& model, const State& state, double distance);

/// Does the same for some elements only, in ascending order.
std::vector<ElementPair> close_pairs(const Model& model, const State& state, const std::vector<ElementIndex>& among,
                                     double distance);

}  // namespace keyblock
