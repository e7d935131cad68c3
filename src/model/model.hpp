// Holds the scene of a computation: elements with their basis, their boundary and the points they carry. It does not
// change.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "model/basis.hpp"
#include "model/edge_load.hpp"
#include "problem/analysis.hpp"
#include "problem/blocks.hpp"

namespace keyblock {

struct Continuum;

/// Corner of a boundary loop. The element lies to the left of the edge to `next`.
struct Vertex {
  ElementIndex element;
  VertexIndex next;
  VertexIndex previous;
  int joint_material = 0;  ///< of the edge that arrives from `previous`
  bool is_inner = false;   ///< that edge leads into another element of the same body: it has no contact
  /// Ends of the boundary edges after and before this vertex. They belong to other elements where the boundary of this
  /// one ends. Unset if the edge that leaves is inner.
  VertexIndex boundary_next = {};
  VertexIndex boundary_previous = {};
};

/// Numbers of the covers of an element: three, or the one that belongs to a block alone.
using CoverList = boost::container::static_vector<int, 3>;

/// Number of an element for the whole run, as elements come and go; indices from 0.
struct Identity {
  int number = 0;  ///< its index in the first scene; pieces cut off later get the next numbers
  int origin = 0;  ///< the element of the first scene that it is, or is a piece of

  bool operator==(const Identity&) const = default;
};

/// Numbers of elements, measured points and bolts for the whole run. Empty lists: their order in the first scene.
struct Identities {
  std::vector<Identity> elements;
  std::vector<int> measured_points;
  std::vector<int> bolts;
  std::vector<int> blocks;  ///< per element the block from which it was cut, if blocks are given meshes

  Identity of_element(int e) const { return elements.empty() ? Identity{e, e} : elements[static_cast<std::size_t>(e)]; }
  int of_measured_point(std::size_t i) const { return of(measured_points, i); }
  int of_bolt(std::size_t i) const { return of(bolts, i); }

 private:
  static int of(const std::vector<int>& numbers, std::size_t i) {
    return numbers.empty() ? static_cast<int>(i) : numbers[i];
  }
};

/// Polygon with a material and a basis. Its unknowns are block number `index` of the linear system.
struct Element {
  int material = 0;
  const Basis* basis = nullptr;
  VertexIndex first_vertex;  ///< outer loop first, then holes, each contiguous
  VertexIndex end_vertex;
  std::vector<int> loop_sizes;
  CoverList covers = {};

  IndexRange<VertexIndex> vertices() const { return {first_vertex, end_vertex}; }
  bool is_on_covers() const { return covers.size() > 1; }
  bool can_move() const { return basis->unknown_count() > 0 || is_on_covers(); }
};

/// Returns true for elements connected through shared nodes; they form one continuum and no contact is sought between
/// them.
inline bool share_a_cover(const Element& a, const Element& b) {
  return std::ranges::any_of(a.covers, [&](int c) { return std::ranges::find(b.covers, c) != b.covers.end(); });
}

/// Point that moves with an element; `curve` is its load (loading point) or its motion (fixed point).
struct CarriedPoint {
  Point start;
  ElementIndex element;
  TimeCurve curve;
  bool holds_in_place = false;  ///< fixed where it is when its scene begins, not where it was drawn
};

/// Point of an element, given by its initial position.
struct MaterialPoint {
  Point start;
  ElementIndex element;
};

/// Axial spring between two material points. Tension is positive:
///       force = pretension + stiffness × elongation,  elongation = present length − initial length,
/// also under compression (the Berkeley program; legacy-formats, bolts). The stiffness belongs to the whole bolt. A
/// bolt whose force exceeds its strength breaks and carries no force afterwards.
///
/// A strength of 0 or below in a file is no limit and becomes infinity here. The Berkeley program read the number but
/// broke no bolt, and a bolt that breaks at once would carry nothing. None of the old files at hand has a bolt. Profile
/// `legacy` breaks none.
struct Bolt {
  MaterialPoint first;
  MaterialPoint second;
  double stiffness = 0;  ///< force / length
  double strength = std::numeric_limits<double>::infinity();
  double pretension = 0;  ///< initial force
  std::string name = {};  ///< from a case file; empty: none

  double start_length() const { return distance(first.start, second.start); }
  bool is_spring() const { return stiffness > 0; }
  /// Returns the pretension of a bolt without stiffness: a constant force, unless it breaks the bolt at once.
  double constant_force() const { return is_spring() || pretension >= strength ? 0 : pretension; }
  double force_at(double length) const { return pretension + stiffness * (length - start_length()); }
};

struct Model {
  Table<ElementIndex, Element> elements;
  Table<VertexIndex, Vertex> vertices;
  std::vector<Point> start_vertices;
  std::vector<Point>
      nodes;  ///< initial positions, of the covers 0, 1, … that elements share; each such element uses three
  std::vector<CarriedPoint> fixed_points;
  std::vector<CarriedPoint> loading_points;
  std::vector<CarriedPoint> measured_points;
  std::vector<Bolt> bolts;
  std::vector<EdgeLoad> edge_loads = {};      ///< of DDA blocks
  std::vector<SupportRow> support_rows = {};  ///< of DDA blocks that can move
  std::shared_ptr<const Continuum>
      continuum;  ///< manifold from which the elements on covers were cut, which come last; null without any
  std::vector<BlockMaterial> block_materials;
  std::vector<JointMaterial> joint_materials;
  Identities identities = {};
  double mean_area = 0;  ///< initial, of the elements
  double scale = 0;      ///< w0: half the greater of width and height of all vertices (Berkeley's rule)

  /// Returns the joint material of the edge that arrives at `vertex`.
  const JointMaterial& joint_at(VertexIndex vertex) const { return joint_material(vertices[vertex].joint_material); }
  /// Returns the number in messages and tables, from 1; scene changes keep it.
  int number_of(ElementIndex e) const { return identities.of_element(e.value).number + 1; }

  const JointMaterial& joint_material(int number) const { return joint_materials[static_cast<std::size_t>(number)]; }
  /// Returns true if elements share unknowns, as those of an NMM body do.
  bool shares_unknowns() const { return continuum != nullptr; }
  const BlockMaterial& material_of(const Element& element) const {
    return block_materials[static_cast<std::size_t>(element.material)];
  }
};

}  // namespace keyblock
