// What a cover file says: elements cut from a mathematical mesh, the physical covers they hang on, and contact loops.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"

namespace keyblock {

/// A closed chain in a list of slots: `size` corners from `first` on (index from 0), and the first again behind them.
struct SlotRange {
  int first = 0;
  int size = 0;

  bool operator==(const SlotRange&) const = default;
};

/// One element: its polygon (counter-clockwise) among the vertex slots, its material, its three covers
/// (counter-clockwise).
struct CoverElement {
  SlotRange vertices;
  int material = -1;          ///< block material, index from 0; -1: not assigned
  std::array<int, 3> covers;  ///< physical covers, index from 0
  Place place = {};           ///< where a file says so

  /// The same element, wherever it is written.
  bool operator==(const CoverElement& other) const {
    return vertices == other.vertices && material == other.material && covers == other.covers;
  }
};

/// A corner of a contact loop. `joint_material` belongs to the edge that leaves here (to the next corner), index from
/// 0.
struct LoopVertex {
  int slot = 0;  ///< vertex slot, index from 0
  int joint_material = 0;

  bool operator==(const LoopVertex&) const = default;
};

/// A point carried by an element.
struct CoverPoint {
  Point position;
  int element = 0;  ///< index from 0
  Place place;
};

/// The cover of a manifold problem. Lengths in the file's unit. Elements share no vertices: neighbours repeat
/// positions, and each chain repeats its first slot at its end.
struct Cover {
  std::vector<CoverElement> elements;
  std::vector<Point> vertices;   ///< vertex slots
  std::vector<Point> nodes;      ///< of every physical cover, the mathematical node it belongs to
  std::vector<SlotRange> loops;  ///< in `loop_vertices`: outer loops counter-clockwise, holes clockwise
  std::vector<LoopVertex> loop_vertices;
  std::vector<CoverPoint> fixed_points;
  std::vector<CoverPoint> loading_points;
  std::vector<CoverPoint> measured_points;
  Place place;  ///< the file

  /// The polygon of an element, the first vertex not repeated.
  std::span<const Point> polygon(const CoverElement& element) const {
    return std::span(vertices).subspan(static_cast<std::size_t>(element.vertices.first),
                                       static_cast<std::size_t>(element.vertices.size));
  }

  /// The corners of a loop, the first not repeated.
  std::vector<Point> corners(const SlotRange& loop) const {
    std::vector<Point> points;
    for (int i = loop.first; i < loop.first + loop.size; ++i)
      points.push_back(vertices[static_cast<std::size_t>(loop_vertices[static_cast<std::size_t>(i)].slot)]);
    return points;
  }
};

}  // namespace keyblock
