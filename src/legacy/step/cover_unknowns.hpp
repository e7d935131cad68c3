// Converts between the unknowns of covers, in which a step is solved, and those of elements, in which terms and
// contacts are written.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "legacy/contact/judge.hpp"
#include "model/state.hpp"
#include "system/solve.hpp"

namespace keyblock {

/// Linear map from the unknowns d of covers to those D of elements at the start of a step, D = A d. A system K D = F of
/// elements becomes A'K A d = A'F of covers. An element with a cover of its own has A = 1. If all have, as DDA blocks
/// do, nothing is done.
class CoverUnknowns {
 public:
  CoverUnknowns(const Model& model, const State& state);

  /// Returns a system of elements as one of covers.
  System of_covers(const System& of_elements) const;

  /// Solves a system of elements for the unknowns of covers.
  std::optional<Solution> solve(const System& of_elements, const SystemKind& kind, Solver& solver) const;

  /// Returns the increments of blocks that keep their velocity for `dt`; empty if covers are shared.
  Eigen::VectorXd steady(const State& state, double dt) const;

  Increments increments(const Solution& solution) const;

  /// Returns the displacements of the nodes of shared covers.
  std::vector<Point> node_steps(const Solution& solution) const;

 private:
  /// Part of one cover in the unknowns of an element.
  struct Part {
    int cover;
    UnknownBlock share;  ///< A, n × unknowns of the cover
  };

  static std::vector<Part> parts_of(const Element& element, Point centroid, const State& state);
  Unknowns unknowns_of(const Solution& solution, ElementIndex element) const;

  const Model& model_;
  bool has_shared_covers_;
  std::vector<int> sizes_;                        // per cover
  std::vector<int> first_rows_;                   // per cover
  Table<ElementIndex, std::vector<Part>> parts_;  // empty if covers are not shared
};

}  // namespace keyblock
