// The scene as it is computed on: elements with their basis, their boundary, and the points they carry. It does not
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
#include "problem/analysis.hpp"
#include "problem/blocks.hpp"

namespace keyblock {

struct Continuum;

/// A corner of a boundary loop. The element lies to the left of the edge to `next`.
struct Vertex {
  ElementIndex element;
  VertexIndex next;
  VertexIndex previous;
  int joint_material = 0;  ///< of the edge that arrives from `previous`
  bool is_inner = false;   ///< that edge leads into another element of the same body: nothing touches it
  /// Where the boundary edge that leaves here ends and the next begins, and where the one before begins: of other
  /// elements where the boundary of this one ends. None where the edge that leaves is inner.
  VertexIndex boundary_next = {};
  VertexIndex boundary_previous = {};
};

/// Numbers of the covers that an element hangs on: three, or the one that is a block's own.
using CoverList = boost::container::static_vector<int, 3>;

/// What an element is called for the whole run, whatever comes and goes about it; indices from 0.
struct Identity {
  int number = 0;  ///< its index in the first scene; pieces cut off later are numbered on from there
  int origin = 0;  ///< the element of the first scene that it is, or is a piece of

  bool operator==(const Identity&) const = default;
};

/// What elements, measured points and bolts are called for the whole run. Empty lists: by their order, as in the first
/// scene.
struct Identities {
  std::vector<Identity> elements;
  std::vector<int> measured_points;
  std::vector<int> bolts;
  std::vector<int> blocks;  ///< of every element the block that it was cut from, where blocks are given meshes

  Identity of_element(int e) const { return elements.empty() ? Identity{e, e} : elements[static_cast<std::size_t>(e)]; }
  int of_measured_point(std::size_t i) const { return of(measured_points, i); }
  int of_bolt(std::size_t i) const { return of(bolts, i); }

 private:
  static int of(const std::vector<int>& numbers, std::size_t i) {
    return numbers.empty() ? static_cast<int>(i) : numbers[i];
  }
};

/// A polygon with a material and a basis. Its unknowns are block number `index` of the system.
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

/// Neighbours, and elements around a node that no joint parts, hang together: they do not touch each other.
inline bool share_a_cover(const Element& a, const Element& b) {
  return std::ranges::any_of(a.covers, [&](int c) { return std::ranges::find(b.covers, c) != b.covers.end(); });
}

/// A point that travels with an element; `curve` is its load (loading point) or its motion (fixed point).
struct CarriedPoint {
  Point start;
  ElementIndex element;
  TimeCurve curve;
  bool holds_in_place = false;  ///< held where it is when its scene begins, not where it was drawn
};

/// A point of an element, by where it lies at the start.
struct MaterialPoint {
  Point start;
  ElementIndex element;
};

/// An axial spring between two material points. Tension is positive:
///     force = pretension + stiffness × elongation,  elongation = present length − length at the start,
/// and so under compression too (the Berkeley program; legacy-formats, bolts). The stiffness belongs to the whole bolt.
/// A bolt whose force exceeds its strength is broken and carries nothing more. A file's strength of 0 or below,
/// infinity here, is no limit: the old program read the number and broke no bolt, and a bolt meant to break at once
/// would hold nothing (none of the old files at hand has a bolt). Profile `legacy` breaks none.
struct Bolt {
  MaterialPoint first;
  MaterialPoint second;
  double stiffness = 0;  ///< force / length
  double strength = std::numeric_limits<double>::infinity();
  double pretension = 0;  ///< force at the start
  std::string name = {};  ///< of a case file; empty: none

  double start_length() const { return distance(first.start, second.start); }
  bool is_spring() const { return stiffness > 0; }
  /// Without stiffness its pretension is a force that stays, unless it breaks the bolt at once.
  double constant_force() const { return is_spring() || pretension >= strength ? 0 : pretension; }
  double force_at(double length) const { return pretension + stiffness * (length - start_length()); }
};

struct Model {
  Table<ElementIndex, Element> elements;
  Table<VertexIndex, Vertex> vertices;
  std::vector<Point> start_vertices;
  std::vector<Point>
      nodes;  ///< at the start, of the covers 0, 1, … that elements share; an element hangs on three of them
  std::vector<CarriedPoint> fixed_points;
  std::vector<CarriedPoint> loading_points;
  std::vector<CarriedPoint> measured_points;
  std::vector<Bolt> bolts;
  std::shared_ptr<const Continuum>
      continuum;  ///< what the elements on covers, the last ones, were cut from; none without them
  std::vector<BlockMaterial> block_materials;
  std::vector<JointMaterial> joint_materials;
  Identities identities = {};
  double mean_area = 0;  ///< of the elements at the start
  double scale = 0;      ///< w0: half the greater of width and height of all vertices (Berkeley's rule)

  /// The joint material of the edge that arrives at `vertex`.
  const JointMaterial& joint_at(VertexIndex vertex) const { return joint_material(vertices[vertex].joint_material); }
  /// As messages and tables call it, from 1, whatever changed since the first scene.
  int number_of(ElementIndex e) const { return identities.of_element(e.value).number + 1; }

  const JointMaterial& joint_material(int number) const { return joint_materials[static_cast<std::size_t>(number)]; }
  /// Whether elements share unknowns, as those of a body on covers do.
  bool shares_unknowns() const { return continuum != nullptr; }
  const BlockMaterial& material_of(const Element& element) const {
    return block_materials[static_cast<std::size_t>(element.material)];
  }
};

}  // namespace keyblock
