// Turns the loops of a block into pieces; see body_graph.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/body_graph.hpp"

namespace keyblock {

BodyGraph graph_of(const BlockPolygon& block) {
  BodyGraph graph;
  graph.materials.push_back(block.material);
  const auto add = [&](const BlockLoop& loop) {
    const int first = static_cast<int>(graph.nodes.size());
    const int count = static_cast<int>(loop.size());
    for (int i = 0; i < count; ++i) {
      const int next = i + 1 == count ? 0 : i + 1;
      graph.nodes.push_back(loop[i].position);
      graph.pieces.push_back({first + i, first + next, false, 0, -1, loop[next].joint_material});
    }
  };
  add(block.outer);
  for (const BlockLoop& hole : block.holes) add(hole);
  return graph;
}

}  // namespace keyblock
