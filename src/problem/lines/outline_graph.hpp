// Builds a graph of the boundary lines of a drawing: lines drawn twice are one, and ends on another line split it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "problem/drawing.hpp"
#include "problem/outline.hpp"

namespace keyblock {

/// Point at which a number of pieces other than two meet.
struct OutlineFault {
  std::size_t line = 0;  ///< a line that ends there, index from 0
  Point at;
  std::size_t pieces = 0;        ///< pieces that meet there; 1: the outline is open
  std::optional<Point> nearest;  ///< the nearest other such point
};

class OutlineGraph {
 public:
  /// Ends nearer than 1e-9 of the extent are one. Coordinates must be finite.
  explicit OutlineGraph(std::span<const JointLine> lines);

  /// Returns true if too many lines lie along one another to separate them within a second; there are no pieces then.
  bool is_tangled() const { return is_tangled_; }
  /// Returns parts of lines between points where they meet, each once.
  std::vector<Segment> pieces() const;
  /// Returns nothing if the outline is a set of closed loops.
  std::optional<OutlineFault> fault() const;
  /// Returns the loops of an outline without a fault.
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
  std::vector<std::pair<int, int>> ends_;  ///< nodes per line
  std::vector<Piece> pieces_;
  std::vector<std::vector<int>> at_;  ///< pieces per node
};

}  // namespace keyblock
