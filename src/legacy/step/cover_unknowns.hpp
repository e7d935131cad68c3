// The unknowns of a step are those of covers; terms and contacts are written in those of elements. Here one becomes the
// other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "legacy/contact/judge.hpp"
#include "model/state.hpp"
#include "system/solve.hpp"

namespace keyblock {

/// How the unknowns D of elements follow from those d of covers at the start of a step: D = A d, so that a system K D =
/// F of elements is A'K A d = A'F of covers. An element with a cover of its own has that cover's unknowns, A = 1; where
/// all have, as blocks do, nothing is done.
class CoverUnknowns {
 public:
  CoverUnknowns(const Model& model, const State& state);

  /// A system of elements as one of covers.
  System of_covers(const System& of_elements) const;

  /// Solves a system of elements for the unknowns of covers.
  std::optional<Solution> solve(const System& of_elements, const SystemKind& kind, Solver& solver) const;

  /// Increments of blocks that go on for `dt` as they are; empty where covers are shared.
  Eigen::VectorXd steady(const State& state, double dt) const;

  Increments increments(const Solution& solution) const;

  /// How far the nodes of shared covers go.
  std::vector<Point> node_steps(const Solution& solution) const;

 private:
  /// The share of one cover in the unknowns of an element.
  struct Part {
    int cover;
    UnknownBlock share;  ///< A, n × unknowns of the cover
  };

  static std::vector<Part> parts_of(const Element& element, Point centroid, const State& state);
  Unknowns unknowns_of(const Solution& solution, ElementIndex element) const;

  const Model& model_;
  bool has_shared_covers_;
  std::vector<int> sizes_;                        // of covers
  std::vector<int> first_rows_;                   // of covers
  Table<ElementIndex, std::vector<Part>> parts_;  // none where covers are not shared
};

}  // namespace keyblock
