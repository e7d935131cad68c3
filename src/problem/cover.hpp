// Holds the contents of a cover file: elements cut from a mathematical mesh, their physical covers, and contact loops.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"

namespace keyblock {

/// Closed chain in a list of slots: `size` corners from `first` on (index from 0), then the first again.
struct SlotRange {
  int first = 0;
  int size = 0;

  bool operator==(const SlotRange&) const = default;
};

/// Element: its polygon (counter-clockwise) among the vertex slots, its material, and its three covers
/// (counter-clockwise).
struct CoverElement {
  SlotRange vertices;
  int material = -1;          ///< block material, index from 0; -1: not assigned
  std::array<int, 3> covers;  ///< physical covers, index from 0
  Place place = {};           ///< set if it comes from a file

  /// Returns true for the same element, ignoring its place in a file.
  bool operator==(const CoverElement& other) const {
    return vertices == other.vertices && material == other.material && covers == other.covers;
  }
};

/// Corner of a contact loop. `joint_material` belongs to the edge that leaves here to the next corner, index from 0.
struct LoopVertex {
  int slot = 0;  ///< vertex slot, index from 0
  int joint_material = 0;

  bool operator==(const LoopVertex&) const = default;
};

/// Point carried by an element.
struct CoverPoint {
  Point position;
  int element = 0;  ///< index from 0
  Place place;
};

/// Cover of a manifold problem. Lengths in the file's unit. Elements share no vertices: neighbours repeat positions,
/// and each chain repeats its first slot at its end.
struct Cover {
  std::vector<CoverElement> elements;
  std::vector<Point> vertices;   ///< vertex slots
  std::vector<Point> nodes;      ///< mathematical node of every physical cover
  std::vector<SlotRange> loops;  ///< in `loop_vertices`: outer loops counter-clockwise, holes clockwise
  std::vector<LoopVertex> loop_vertices;
  std::vector<CoverPoint> fixed_points;
  std::vector<CoverPoint> loading_points;
  std::vector<CoverPoint> measured_points;
  Place place;  ///< source file

  /// Returns the polygon of an element, the first vertex not repeated.
  std::span<const Point> polygon(const CoverElement& element) const {
    return std::span(vertices).subspan(static_cast<std::size_t>(element.vertices.first),
                                       static_cast<std::size_t>(element.vertices.size));
  }

  /// Returns the corners of a loop, the first not repeated.
  std::vector<Point> corners(const SlotRange& loop) const {
    std::vector<Point> points;
    for (int i = loop.first; i < loop.first + loop.size; ++i)
      points.push_back(vertices[static_cast<std::size_t>(loop_vertices[static_cast<std::size_t>(i)].slot)]);
    return points;
  }
};

}  // namespace keyblock
