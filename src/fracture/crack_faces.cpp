// Compares each edge with the pieces whose boxes it meets; see crack_faces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/crack_faces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/box_tree.hpp"

namespace keyblock {
namespace {

// Distance of an end from a piece, per length of the piece, that counts as round-off of cutting.
constexpr double kBeside = 1e-9;

/// Returns true if the edge runs forward along the piece, false if backward, nothing if it does not lie on the piece.
std::optional<bool> runs_along(Point from, Point to, Point start, Point end) {
  const Point way = to - from;
  const double size = length(way);
  for (const Point p : {start, end}) {
    if (std::abs(cross(way, p - from)) > kBeside * size * size) return std::nullopt;
    const double station = dot(way, p - from) / (size * size);
    if (station < -kBeside || station > 1 + kBeside) return std::nullopt;
  }
  return dot(way, end - start) > 0;
}

struct Piece {
  std::size_t crack;
  Point from, to;
};

std::vector<Piece> pieces_of(std::span<const CrackPlan> cracks) {
  std::vector<Piece> pieces;
  for (std::size_t c = 0; c < cracks.size(); ++c)
    for (std::size_t i = 0; i + 1 < cracks[c].along.size(); ++i)
      pieces.push_back({c, cracks[c].along[i], cracks[c].along[i + 1]});
  return pieces;
}

Box box_of(Point a, Point b) {
  Box box;
  box.add(a);
  box.add(b);
  return box;
}

}  // namespace

std::vector<CrackFrame> with_faces(std::span<const CrackPlan> cracks, const std::vector<FieldElement>& elements) {
  const std::vector<Piece> pieces = pieces_of(cracks);
  std::vector<Box> boxes;
  double reach = 0;
  for (const Piece& piece : pieces) {
    boxes.push_back(box_of(piece.from, piece.to));
    reach = std::max(reach, kBeside * distance(piece.from, piece.to));
  }
  std::vector<std::array<const FieldCorner*, 2>> edges;
  for (const FieldElement& element : elements)
    for (const std::vector<FieldCorner>& loop : element.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        edges.push_back({&loop[i], &loop[(i + 1) % loop.size()]});
        boxes.push_back(box_of(loop[i].position, edges.back()[1]->position));
      }
  std::vector<std::vector<std::pair<std::size_t, bool>>> along(cracks.size());  // edges, each true if it runs forward
  visit_touching(boxes, reach, [&](int i, int j) {
    const auto piece = static_cast<std::size_t>(i), other = static_cast<std::size_t>(j);
    if (piece >= pieces.size()) return false;
    if (other < pieces.size()) return true;
    const auto [start, end] = edges[other - pieces.size()];
    if (const auto forward = runs_along(pieces[piece].from, pieces[piece].to, start->position, end->position))
      along[pieces[piece].crack].emplace_back(other - pieces.size(), *forward);
    return true;
  });
  std::vector<CrackFrame> frames;
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    CrackFrame& frame = frames.emplace_back(CrackFrame{cracks[c].is_shear, cracks[c].along});
    std::ranges::sort(along[c]);
    for (const auto& [edge, forward] : along[c])
      frame.faces.push_back({forward, {*edges[edge][forward ? 0 : 1], *edges[edge][forward ? 1 : 0]}});
  }
  return frames;
}

}  // namespace keyblock
