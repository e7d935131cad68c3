// Identifies vertices by their initial positions, which no change moves.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scene/scene_map.hpp"

namespace keyblock {
namespace {

// Per scale of the scene: a cut through a corner finds it again within round-off.
constexpr double kSamePlace = 1e-12;

}  // namespace

Table<VertexIndex, VertexIndex> vertices_before(const Model& before, const Model& after,
                                                const Table<ElementIndex, ElementIndex>& elements) {
  const auto place = [](const Model& model, VertexIndex v) {
    return model.start_vertices[static_cast<std::size_t>(v.value)];
  };
  Table<VertexIndex, VertexIndex> found;
  found.resize(after.vertices.size());
  for (ElementIndex e : indices(after.elements))
    for (VertexIndex v : after.elements[e].vertices())
      for (VertexIndex old : before.elements[elements[e]].vertices())
        if (distance(place(after, v), place(before, old)) <= kSamePlace * before.scale) {
          found[v] = old;
          break;
        }
  return found;
}

}  // namespace keyblock
