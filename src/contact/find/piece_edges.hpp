// Defines the edges of convex pieces at their present places, for the search for touches.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "contact/find/candidates.hpp"
#include "contact/find/convex_pieces.hpp"

namespace keyblock {

/// Edge of a convex piece at its present place.
struct Edge {
  VertexIndex start;
  VertexIndex end;
  bool is_inner = false;
  bool from_reflex = false, to_reflex = false;  ///< a reflex corner is at the start or the end
  Point from;                                   ///< position of the start
  Point direction;                              ///< unit vector
  double length = 0;

  Edge(const ConvexPiece& piece, std::size_t i, std::size_t next, const Table<VertexIndex, Point>& vertices)
      : start(piece.corners[i]),
        end(piece.corners[next]),
        is_inner(piece.is_inner[i]),
        from_reflex(piece.is_reflex[i]),
        to_reflex(piece.is_reflex[next]),
        from(vertices[start]) {
    const Point along = vertices[end] - from;
    length = keyblock::length(along);
    direction = (1 / length) * along;
  }
};

/// Edges of a convex piece; edge i starts at its corner i.
using EdgesOfPiece = std::span<const Edge>;

/// Edges of all elements in some pairs, computed once: a block belongs to about six pairs.
class EdgesOfPieces {
 public:
  EdgesOfPieces(const std::vector<ElementPair>& pairs, const Table<ElementIndex, ConvexPieces>& pieces,
                const Table<VertexIndex, Point>& vertices)
      : pieces_(pieces), first_(pieces.size(), kNone) {
    const auto add = [&](ElementIndex e) {
      if (first_[e] != kNone) return;
      first_[e] = edges_.size();
      for (const ConvexPiece& piece : pieces[e])
        for (std::size_t i = 0; i < piece.corners.size(); ++i)
          edges_.emplace_back(piece, i, i + 1 == piece.corners.size() ? 0 : i + 1, vertices);
    };
    for (const ElementPair& pair : pairs) {
      add(pair.lower);
      add(pair.upper);
    }
  }

  template <class Visit>
  void for_each_piece(ElementIndex e, const Visit& visit) const {
    std::size_t first = first_[e];
    for (const ConvexPiece& piece : pieces_[e]) {
      visit(EdgesOfPiece(edges_).subspan(first, piece.corners.size()));
      first += piece.corners.size();
    }
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  const Table<ElementIndex, ConvexPieces>& pieces_;
  Table<ElementIndex, std::size_t> first_;  ///< in `edges_`
  std::vector<Edge> edges_;
};

}  // namespace keyblock
