// Turns chains into loops without straight vertices; see blocks_of_faces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/blocks_of_faces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/predicates.hpp"

namespace keyblock {

void BlocksOfFaces::make() {
  result_.report.faces = static_cast<int>(faces_.size());
  result_.report.pruned_edges = static_cast<int>(arrangement_.edges.size());
  std::vector<char> is_used(arrangement_.nodes.size(), 0);
  for (const Edge& e : arrangement_.edges) is_used[e.from] = is_used[e.to] = 1;
  result_.report.pruned_nodes = static_cast<int>(std::count(is_used.begin(), is_used.end(), 1));
  for (std::size_t i = 0; i < faces_.size(); ++i) add(faces_[i], static_cast<int>(i));
}

void BlocksOfFaces::add(const Face& face, int number_of_face) {
  std::vector<int> lines;
  BlockPolygon block{0, loop_of(face.outer, lines), {}};
  if (block.outer.size() < 3) {
    notes_.warn({"sliver_removed"}, notes_.place(face.outer.front().line));
    return;
  }
  for (const Chain& hole : face.holes) {
    std::vector<int> lines_of_hole;
    BlockLoop loop = loop_of(hole, lines_of_hole);
    if (loop.size() < 3) continue;
    lines.insert(lines.end(), lines_of_hole.begin(), lines_of_hole.end());
    notes_.warn({"block_inside_block", {{}, {}, {static_cast<int>(result_.blocks.blocks.size()) + 1}}},
                notes_.place(hole.front().line));
    block.holes.push_back(std::move(loop));
  }
  result_.blocks.blocks.push_back(std::move(block));
  face_of_block_.push_back(number_of_face);
  lines_of_block_.push_back(std::move(lines));
}

BodyGraph BlocksOfFaces::graph(const std::vector<int>& kept, const std::vector<Edge>& slits) const {
  BodyGraph graph;
  graph.nodes.reserve(arrangement_.nodes.size());
  for (const Node& node : arrangement_.nodes) graph.nodes.push_back(node.position);
  for (const Edge& e : arrangement_.edges) graph.pieces.push_back({e.from, e.to, false, -1, -1, material(e.line)});
  for (std::size_t body = 0; body < kept.size(); ++body) {
    const Face& face = faces_[face_of_block_[kept[body]]];
    const auto mark = [&](const Chain& chain) {
      for (const ChainLink& link : chain) {
        BodyPiece& piece = graph.pieces[link.half_edge / 2];
        (link.half_edge % 2 == 0 ? piece.left : piece.right) = static_cast<int>(body);
      }
    };
    mark(face.outer);
    for (const Chain& hole : face.holes) mark(hole);
    graph.materials.push_back(result_.blocks.blocks[body].material);
  }
  for (const Edge& e : slits) graph.pieces.push_back({e.from, e.to, true, -1, -1, material(e.line)});
  return graph;
}

// Leaves out straight vertices. A joined edge keeps the material of its last part, and its line, which is appended to
// `lines`.
BlockLoop BlocksOfFaces::loop_of(const Chain& chain, std::vector<int>& lines) const {
  BlockLoop loop;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const ChainLink& before = chain[i == 0 ? chain.size() - 1 : i - 1];
    const ChainLink& after = chain[i + 1 == chain.size() ? 0 : i + 1];
    if (is_straight(before, chain[i], after)) continue;
    loop.push_back({arrangement_.nodes[chain[i].node].position, material(chain[i].line)});
    lines.push_back(static_cast<int>(notes_.number(chain[i].line)) - 1);
  }
  return loop;
}

bool BlocksOfFaces::is_straight(const ChainLink& before, const ChainLink& here, const ChainLink& after) const {
  const Point a = arrangement_.nodes[before.node].position;
  const Point b = arrangement_.nodes[here.node].position;
  const Point c = arrangement_.nodes[after.node].position;
  if (result_.report.tolerances.is_exact()) {
    const Segment& first = arrangement_.lines[here.line];
    const Segment& second = arrangement_.lines[after.line];
    return here.line == after.line || turn(first.start, first.end, second.start, second.end) == 0;
  }
  return std::fabs(cross(b - a, c - a)) <= result_.report.tolerances.collinear;
}

}  // namespace keyblock
