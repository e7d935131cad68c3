// Boxes of elements, and pairs of elements close enough to matter.
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

/// Of the vertices of an element as they lie now.
Box box_of(const Model& model, const State& state, ElementIndex element);

/// Pairs whose bounding boxes touch when one is grown by `distance`, ascending; the order does not depend on
/// the search.
std::vector<ElementPair> close_pairs(const Model& model, const State& state, double distance);

/// The same among some elements only, ascending.
std::vector<ElementPair> close_pairs(const Model& model, const State& state, const std::vector<ElementIndex>& among,
                                     double distance);

}  // namespace keyblock
