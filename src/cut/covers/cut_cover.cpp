// Builds elements, covers and boundary loops from faces; see cut_cover.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/covers/cut_cover.hpp"

#include <utility>
#include <vector>

#include "cut/bodies/cracks.hpp"
#include "cut/covers/cover_faces.hpp"
#include "cut/covers/physical_covers.hpp"

namespace keyblock {
namespace {

class Elements {
 public:
  Elements(const BodyGraph& graph, const CoverFaces& cut, Manifold& manifold)
      : graph_(graph), cut_(cut), manifold_(manifold) {
    const std::size_t half_edges = cut.face_of_half_edge.size();
    next_.assign(half_edges, -1);
    corner_.assign(half_edges, -1);
  }

  void add_all() {
    manifold_.elements.reserve(cut_.faces.size());
    for (const CoverFace& face : cut_.faces) {
      ManifoldElement element;
      element.triangle = face.triangle;
      element.body = face.body;
      element.outer = add_loop(face.face.outer);
      element.holes = {static_cast<int>(manifold_.holes.size()), static_cast<int>(face.face.holes.size())};
      for (const Chain& hole : face.face.holes) manifold_.holes.push_back(add_loop(hole));
      manifold_.elements.push_back(element);
    }
  }

  /// Walks around each connected piece: from one boundary edge to the next, across the edges to neighbours in between.
  void add_boundary() {
    std::vector<char> is_done(corner_.size(), 0);
    for (std::size_t h = 0; h < corner_.size(); ++h) {
      const int first = static_cast<int>(h);
      if (!is_boundary(first) || is_done[h]) continue;
      SlotRange loop{static_cast<int>(manifold_.boundary_edges.size()), 0};
      for (int at = first; !is_done[at]; at = next_boundary(at)) {
        is_done[at] = 1;
        manifold_.boundary_edges.push_back({cut_.face_of_half_edge[at], corner_[at]});
        ++loop.size;
      }
      manifold_.boundary_loops.push_back(loop);
    }
  }

 private:
  SlotRange add_loop(const Chain& chain) {
    const SlotRange range{static_cast<int>(manifold_.corners.size()), static_cast<int>(chain.size())};
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const int leaving = chain[i + 1 == chain.size() ? 0 : i + 1].half_edge;
      next_[chain[i].half_edge] = leaving;
      corner_[leaving] = range.first + static_cast<int>(i);
      ElementCorner corner{cut_.arrangement.nodes[chain[i].node].position, -1, -1};
      if (is_open(leaving)) {
        corner.neighbour = cut_.face_of_half_edge[leaving ^ 1];
      } else {
        const int piece = cut_.origins[leaving / 2].piece;
        corner.joint_material = piece < 0 ? 0 : graph_.pieces[piece].joint_material;
      }
      manifold_.corners.push_back(corner);
    }
    return range;
  }

  /// Returns true for a side of the mesh that is no joint and has the same body beyond.
  bool is_open(int half_edge) const {
    const int here = cut_.face_of_half_edge[half_edge];
    const int beyond = cut_.face_of_half_edge[half_edge ^ 1];
    return cut_.origins[half_edge / 2].piece < 0 && here >= 0 && beyond >= 0 &&
           cut_.faces[here].body == cut_.faces[beyond].body;
  }

  bool is_boundary(int half_edge) const { return corner_[half_edge] >= 0 && !is_open(half_edge); }

  int next_boundary(int half_edge) const {
    int h = next_[half_edge];
    while (is_open(h)) h = next_[h ^ 1];
    return h;
  }

  const BodyGraph& graph_;
  const CoverFaces& cut_;
  Manifold& manifold_;
  std::vector<int> next_;    // per half-edge of an element, in its loop
  std::vector<int> corner_;  // corner from which the half-edge starts
};

/// Renumbers the bodies that have elements; an excavation along an outline may leave a body without any.
void leave_out_empty(Manifold& manifold) {
  std::vector<int> number(manifold.body_materials.size(), -1);
  for (const ManifoldElement& element : manifold.elements) number[static_cast<std::size_t>(element.body)] = 0;
  std::vector<int> materials;
  for (std::size_t b = 0; b < number.size(); ++b) {
    if (number[b] < 0) continue;
    number[b] = static_cast<int>(materials.size());
    materials.push_back(manifold.body_materials[b]);
  }
  for (ManifoldElement& element : manifold.elements) element.body = number[static_cast<std::size_t>(element.body)];
  manifold.body_materials = std::move(materials);
}

}  // namespace

Manifold cut_cover(const BodyGraph& graph, TriangleMesh mesh, EmptyBodies empty) {
  const CoverFaces cut = cover_faces(graph, mesh);
  Manifold manifold;
  manifold.mesh = std::move(mesh);
  manifold.body_materials = graph.materials;
  Elements elements(graph, cut, manifold);
  elements.add_all();
  if (empty == EmptyBodies::are_left_out) leave_out_empty(manifold);
  elements.add_boundary();
  set_covers(manifold);
  manifold.tips = tips_of(graph);
  return manifold;
}

}  // namespace keyblock
