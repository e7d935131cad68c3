// Holds bodies on a mathematical cover: a triangular mesh, the elements cut from it by bodies and joints, and their
// physical covers. Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/point.hpp"
#include "problem/cover.hpp"

namespace keyblock {

/// Conforming mesh; each triangle names its nodes counter-clockwise.
struct TriangleMesh {
  std::vector<Point> nodes;
  std::vector<std::array<int, 3>> triangles;
};

/// Corner of an element, and the edge that leaves it to the next corner of its loop. The edge is part of a side of the
/// element's triangle and leads to `neighbour`, with which the element shares two covers. On the boundary `neighbour`
/// is -1.
struct ElementCorner {
  Point position;
  int neighbour = -1;
  int joint_material = -1;  ///< of a boundary edge, index from 0
};

/// Connected part of one body in one triangle of the mesh. Loops have the element on their left.
struct ManifoldElement {
  int triangle = 0;
  int body = 0;
  std::array<int, 3> covers{};  ///< `covers[k]` belongs to node k of the triangle
  SlotRange outer;              ///< corners, counter-clockwise
  SlotRange holes;              ///< in `Manifold::holes`; usually empty
};

/// One of the pieces into which joints cut the star of a mathematical node.
struct PhysicalCover {
  int node = 0;        ///< of the mesh
  SlotRange elements;  ///< in `Manifold::cover_elements`
};

/// Edge of the boundary of bodies or of a joint: it leaves `corner`, which is a corner of `element`.
struct BoundaryEdge {
  int element = 0;
  int corner = 0;
};

/// Points that elements carry, in the order of the files.
struct ElementPoints {
  std::vector<CoverPoint> fixed;
  std::vector<CoverPoint> loading;
  std::vector<CoverPoint> measured;
};

/// End of a crack, or of a joint, inside a body.
struct CrackTip {
  Point at;
  Point ahead;               ///< of length 1: along the crack, into the rock
  double room = 0;           ///< distance to the nearest line other than the straight end of the crack itself
  const char* nearest = "";  ///< name of that line, in words
};

/// Elements and covers. All indices from 0. Elements share no corners; neighbours and the two sides of a joint repeat
/// positions to the bit.
struct Manifold {
  TriangleMesh mesh;
  std::vector<int> body_materials;  ///< block material per body
  std::vector<ManifoldElement> elements;
  std::vector<ElementCorner> corners;
  std::vector<SlotRange> holes;  ///< of elements, in `corners`, clockwise
  std::vector<PhysicalCover> covers;
  std::vector<int> cover_elements;
  std::vector<SlotRange> boundary_loops;  ///< in `boundary_edges`; the connected piece lies to the left of every edge
  std::vector<BoundaryEdge> boundary_edges;  ///< each ends where the next of its loop begins
  std::vector<CrackTip> tips = {};

  std::span<const ElementCorner> loop(const SlotRange& range) const {
    return std::span(corners).subspan(static_cast<std::size_t>(range.first), static_cast<std::size_t>(range.size));
  }
  std::span<const SlotRange> holes_of(const ManifoldElement& element) const {
    return std::span(holes).subspan(static_cast<std::size_t>(element.holes.first),
                                    static_cast<std::size_t>(element.holes.size));
  }
  /// Returns the corners of the element's loops: the outer one, then its holes.
  std::vector<std::vector<Point>> polygon(const ManifoldElement& element) const {
    std::vector<std::vector<Point>> loops;
    const auto add = [&](const SlotRange& range) {
      loops.emplace_back();
      for (const ElementCorner& corner : loop(range)) loops.back().push_back(corner.position);
    };
    add(element.outer);
    for (const SlotRange& hole : holes_of(element)) add(hole);
    return loops;
  }
  std::span<const int> elements_of(const PhysicalCover& cover) const {
    return std::span(cover_elements)
        .subspan(static_cast<std::size_t>(cover.elements.first), static_cast<std::size_t>(cover.elements.size));
  }
  /// Returns the corners of the element's triangle, in the order of its covers.
  std::array<Point, 3> triangle(const ManifoldElement& element) const {
    const std::array<int, 3>& t = mesh.triangles[static_cast<std::size_t>(element.triangle)];
    return {mesh.nodes[static_cast<std::size_t>(t[0])], mesh.nodes[static_cast<std::size_t>(t[1])],
            mesh.nodes[static_cast<std::size_t>(t[2])]};
  }
};

}  // namespace keyblock
