// The scene as it is computed on: elements with their basis, their boundary, and the points they carry. It does not
// change.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/index.hpp"
#include "model/basis.hpp"
#include "problem/analysis.hpp"
#include "problem/blocks.hpp"

namespace keyblock {

/// A corner of a boundary loop. The element lies to the left of the edge to `next`.
struct Vertex {
  ElementIndex element;
  VertexIndex next;
  VertexIndex previous;
  int joint_material = 0;  ///< of the edge that arrives from `previous`
};

/// A polygon with a material and a basis. Its unknowns are block number `index` of the system.
struct Element {
  int material = 0;
  const Basis* basis = nullptr;
  VertexIndex first_vertex;  ///< outer loop first, then holes, each contiguous
  VertexIndex end_vertex;
  std::vector<int> loop_sizes;

  IndexRange<VertexIndex> vertices() const { return {first_vertex, end_vertex}; }
};

/// A point that travels with an element; `curve` is its load (loading point) or its motion (fixed point).
struct CarriedPoint {
  Point start;
  ElementIndex element;
  TimeCurve curve;
};

struct Model {
  Table<ElementIndex, Element> elements;
  Table<VertexIndex, Vertex> vertices;
  std::vector<Point> start_vertices;
  std::vector<CarriedPoint> fixed_points;
  std::vector<CarriedPoint> loading_points;
  std::vector<CarriedPoint> measured_points;
  std::vector<BlockMaterial> block_materials;
  std::vector<JointMaterial> joint_materials;
  double mean_area = 0;  ///< of the elements at the start
  double scale = 0;      ///< w0: half the greater of width and height of all vertices (Berkeley's rule)

  /// The joint material of the edge that arrives at `vertex`.
  const JointMaterial& joint_at(VertexIndex vertex) const {
    return joint_materials[static_cast<std::size_t>(vertices[vertex].joint_material)];
  }
  const BlockMaterial& material_of(const Element& element) const {
    return block_materials[static_cast<std::size_t>(element.material)];
  }
};

}  // namespace keyblock
