// Moves nodes beside lines; see snap_nodes.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/snap_nodes.hpp"

#include <algorithm>
#include <vector>

#include "geometry/segment.hpp"
#include "problem/lines/segment_grid.hpp"

namespace keyblock {

int snap_nodes(TriangleMesh& mesh, const BodyGraph& graph, double reach) {
  std::vector<Segment> pieces;
  for (const BodyPiece& piece : graph.pieces) pieces.push_back({graph.nodes[piece.from], graph.nodes[piece.to]});
  SegmentGrid grid(pieces, reach);
  int moved = 0;
  for (Point& node : mesh.nodes) {
    double least = reach;
    Point nearest = node;
    for (const int k : grid.near({node, node}, static_cast<int>(pieces.size()))) {
      const Point foot_point = point_at(pieces[k], std::clamp(foot(pieces[k], node), 0.0, 1.0));
      const double gap = distance(node, foot_point);
      if (gap >= least) continue;
      least = gap;
      nearest = foot_point;
    }
    if (nearest == node) continue;
    node = nearest;
    ++moved;
  }
  return moved;
}

}  // namespace keyblock
