// Finds the sets of movable elements that contacts and bolts connect.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "contact/find/candidates.hpp"
#include "contact/find/touch.hpp"

namespace keyblock {

/// Sets of elements. Elements that cannot move do not connect others; each is a set of its own.
class ConnectedSets {
 public:
  /// Connects the elements of `pairs`, in any order, and those of bolts. `supported`: elements with a support of their
  /// own.
  ConnectedSets(const Model& model, std::vector<ElementPair> pairs, const std::vector<ElementIndex>& supported);

  /// Returns the lowest element of each element's set.
  const std::vector<std::size_t>& numbers() const { return numbers_; }
  std::size_t of(ElementIndex e) const { return numbers_[static_cast<std::size_t>(e.value)]; }

  /// Returns true if the set has a support, or is connected to an element that cannot move.
  bool is_held(ElementIndex e) const { return is_held_[of(e)]; }

 private:
  std::vector<std::size_t> numbers_;
  std::vector<bool> is_held_;  ///< by the number of a set
};

/// Returns the elements of both sides of each contact.
std::vector<ElementPair> pairs_of(const Model& model, const Touches& touches);

}  // namespace keyblock
