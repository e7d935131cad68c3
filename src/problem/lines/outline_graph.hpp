// The boundary lines of a drawing as a graph: lines drawn twice are one, and ends on another line part it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "problem/drawing.hpp"
#include "problem/outline.hpp"

namespace keyblock {

/// A point where not exactly two pieces of the outline meet.
struct OutlineFault {
  std::size_t line = 0;  ///< one that ends there, index from 0
  Point at;
  std::size_t pieces = 0;        ///< that meet there; 1: the outline is open
  std::optional<Point> nearest;  ///< the nearest other such point
};

class OutlineGraph {
 public:
  /// Ends nearer than 1e-9 of the extent are one. Coordinates are finite.
  explicit OutlineGraph(std::span<const JointLine> lines);

  /// Too many lines lie along one another to tell them apart within a second: there are no pieces.
  bool is_tangled() const { return is_tangled_; }
  /// Parts of lines between points where they meet, each once.
  std::vector<Segment> pieces() const;
  /// Nothing where the outline is a set of closed loops.
  std::optional<OutlineFault> fault() const;
  /// Loops of an outline without a fault.
  std::vector<Outline> loops() const;

 private:
  struct Piece {
    int from = 0;
    int to = 0;
    std::size_t line = 0;
  };

  void find_nodes(std::span<const JointLine> lines);
  void make_pieces(std::span<const JointLine> lines);
  void link();

  double same_ = 0;
  bool is_tangled_ = false;
  std::vector<Point> nodes_;
  std::vector<std::pair<int, int>> ends_;  ///< nodes of each line
  std::vector<Piece> pieces_;
  std::vector<std::vector<int>> at_;  ///< pieces of each node
};

}  // namespace keyblock
