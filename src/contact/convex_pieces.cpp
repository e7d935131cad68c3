// Cuts at one reflex corner after another, each time along the shortest diagonal that makes the corner convex.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/convex_pieces.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

// Sine of the turn below which a vertex lies on a straight edge. Cutting leaves vertices where joints meet an edge; drawings
// carry ten digits, so their turn is far below this, and a corner of less than 0.006 degrees is none to the eye.
constexpr double kStraightSine = 1e-4;

// A corner that turns by less than this after a cut is avoided where another diagonal does not leave it.
constexpr double kClearSine = 0.02;

double sine_of_turn(Point before, Point at, Point after) {
  const Point arriving = at - before;
  const Point leaving = after - at;
  return cross(arriving, leaving) / (length(arriving) * length(leaving));
}

// A tip, where the edge turns back, is none.
bool is_straight(Point before, Point at, Point after) {
  return std::abs(sine_of_turn(before, at, after)) <= kStraightSine && dot(at - before, after - at) > 0;
}

class Cutter {
 public:
  explicit Cutter(const Model& model) : model_(model) {}

  ConvexPieces run(const Element& element) {
    const std::vector<VertexIndex> ring = distinct(element);
    ConvexPiece whole;
    const auto is_inner = [&](std::size_t i) { return model_.vertices[ring[i % ring.size()]].is_inner; };
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const bool straight =
          is_straight(at(ring[(i + ring.size() - 1) % ring.size()]), at(ring[i]), at(ring[(i + 1) % ring.size()]));
      if (straight && is_inner(i) == is_inner(i + 1)) continue;
      whole.corners.push_back(ring[i]);
      whole.is_inner.push_back(is_inner(i + 1));  // of the edge that leaves here
    }
    if (std::ranges::count(whole.is_inner, false) == 0) return {};
    cut(whole);
    return std::move(pieces_);
  }

 private:
  // Vertices, those left out that lie where the one before lies.
  std::vector<VertexIndex> distinct(const Element& element) const {
    std::vector<VertexIndex> ring;
    for (VertexIndex v : element.vertices())
      if (at(v) != at(model_.vertices[v].previous)) ring.push_back(v);
    return ring;
  }

  Point at(VertexIndex v) const { return model_.start_vertices[static_cast<std::size_t>(v.value)]; }
  static std::size_t wrapped(const ConvexPiece& p, std::size_t i) { return i % p.corners.size(); }
  Point corner(const ConvexPiece& p, std::size_t i) const { return at(p.corners[wrapped(p, i)]); }

  void cut(const ConvexPiece& piece) {
    const std::size_t count = piece.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (sine_of_turn(corner(piece, i + count - 1), corner(piece, i), corner(piece, i + 1)) > -kStraightSine) continue;
      const std::optional<std::size_t> end = best_diagonal(piece, i);
      if (!end) continue;
      cut(part(piece, i, *end));
      cut(part(piece, *end, i));
      return;
    }
    pieces_.push_back(piece);
  }

  // Corners first … last and the diagonal back.
  static ConvexPiece part(const ConvexPiece& piece, std::size_t first, std::size_t last) {
    ConvexPiece result;
    for (std::size_t i = first;; i = wrapped(piece, i + 1)) {
      result.corners.push_back(piece.corners[i]);
      result.is_inner.push_back(i == last || piece.is_inner[i]);
      if (i == last) return result;
    }
  }

  std::optional<std::size_t> best_diagonal(const ConvexPiece& piece, std::size_t from) const {
    const std::size_t count = piece.corners.size();
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    Cut best_cut = Cut::leaves_it;
    for (std::size_t k = 2; k + 1 < count; ++k) {
      const std::size_t to = wrapped(piece, from + k);
      if (!is_inside(piece, from, to)) continue;
      const Cut made = cut_made(piece, from, to);
      const double size = distance(corner(piece, from), corner(piece, to));
      if (made > best_cut || (made == best_cut && size < least)) {
        best = to;
        least = size;
        best_cut = made;
      }
    }
    return best;
  }

  // What a diagonal makes of the reflex corner that it starts from. A straight corner would leave an inner and an outer edge on one
  // line, and contact could not tell whose face it is.
  enum class Cut { leaves_it, makes_straight, makes_convex };

  Cut cut_made(const ConvexPiece& piece, std::size_t from, std::size_t to) const {
    const std::size_t count = piece.corners.size();
    const auto turn = [&](std::size_t before, std::size_t at, std::size_t after) {
      return sine_of_turn(corner(piece, before), corner(piece, at), corner(piece, after));
    };
    const double least = std::min(turn(from + count - 1, from, to), turn(to, from, from + 1));
    if (least <= -kStraightSine) return Cut::leaves_it;
    const double at_end = std::min(std::abs(turn(to + count - 1, to, from)), std::abs(turn(from, to, to + 1)));
    return std::min(least, at_end) > kClearSine ? Cut::makes_convex : Cut::makes_straight;
  }

  bool is_inside(const ConvexPiece& piece, std::size_t from, std::size_t to) const {
    const Segment diagonal{corner(piece, from), corner(piece, to)};
    std::vector<Point> loop;
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
      loop.push_back(corner(piece, i));
      const std::size_t next = wrapped(piece, i + 1);
      if (i == from || i == to || next == from || next == to) continue;
      if (meeting(diagonal, {corner(piece, i), corner(piece, next)}) != Meeting::none) return false;
    }
    return side(loop, point_at(diagonal, 0.5)) == Side::inside;
  }

  const Model& model_;
  ConvexPieces pieces_;
};

}  // namespace

ConvexPieces convex_pieces(const Model& model, ElementIndex e) {
  const Element& element = model.elements[e];
  if (element.loop_sizes.size() > 1) return {};
  return Cutter(model).run(element);
}

}  // namespace keyblock
