// Joins holes to the outer loop, then cuts at one reflex corner after another. Each cut is the shortest diagonal that
// makes the corner convex.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/find/convex_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

// Sine of the turn below which a vertex lies on a straight edge. Cutting leaves vertices where joints meet an edge.
// Their turn is far smaller, because drawings have ten digits. A turn below 0.006 degrees is no visible corner.
constexpr double kStraightSine = 1e-4;

double sine_of_turn(Point before, Point at, Point after) {
  const Point arriving = at - before;
  const Point leaving = after - at;
  return cross(arriving, leaving) / (length(arriving) * length(leaving));
}

// A tip, where the edge turns back, is not straight.
bool is_straight(Point before, Point at, Point after) {
  return std::abs(sine_of_turn(before, at, after)) <= kStraightSine && dot(at - before, after - at) > 0;
}

class Cutter {
 public:
  explicit Cutter(const Model& model) : model_(model) {}

  ConvexPieces run(const Element& element) {
    std::vector<ConvexPiece> loops;
    VertexIndex first = element.first_vertex;
    for (const int size : element.loop_sizes) {
      loops.push_back(corners_of(first, size));
      first.value += size;
    }
    ConvexPiece whole = std::move(loops.front());
    loops.erase(loops.begin());
    has_bridges_ = !loops.empty();
    while (!loops.empty())
      if (!bridge(whole, loops)) return {};
    if (std::ranges::count(whole.is_inner, false) == 0) return {};
    cut(whole);
    if (has_bridges_ && !std::ranges::all_of(pieces_, [&](const ConvexPiece& piece) { return is_convex(piece); }))
      return {};
    return std::move(pieces_);
  }

 private:
  bool is_convex(const ConvexPiece& p) const {
    for (std::size_t i = 0; i < p.corners.size(); ++i)
      if (sine_of_turn(corner(p, i + p.corners.size() - 1), corner(p, i), corner(p, i + 1)) < -kStraightSine)
        return false;
    return true;
  }

  ConvexPiece corners_of(VertexIndex first, int size) const {
    const std::vector<VertexIndex> ring = distinct(first, size);
    ConvexPiece loop;
    const auto is_inner = [&](std::size_t i) { return model_.vertices[ring[i % ring.size()]].is_inner; };
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point before = at(ring[(i + ring.size() - 1) % ring.size()]);
      const Point after = at(ring[(i + 1) % ring.size()]);
      if (is_straight(before, at(ring[i]), after) && is_inner(i) == is_inner(i + 1)) continue;
      loop.corners.push_back(ring[i]);
      loop.is_inner.push_back(is_inner(i + 1));  // of the edge that leaves this corner
      const Outline outline = outline_at(ring[i]);
      const Point arriving = outline.before ? at(outline.before) : before;
      const Point leaving = outline.after ? at(outline.after) : after;
      loop.is_reflex.push_back(sine_of_turn(arriving, at(ring[i]), leaving) < -kStraightSine);
    }
    return loop;
  }

  /// Neighbours of a corner on the outline of its body that belong to other elements, or none.
  struct Outline {
    VertexIndex before, after;
  };

  Outline outline_at(VertexIndex v) const {
    const Vertex& here = model_.vertices[v];
    const bool arrives = !here.is_inner, leaves = !model_.vertices[here.next].is_inner;
    if (leaves && !arrives) return {here.boundary_previous, {}};
    if (leaves || !arrives) return {};
    return {{}, model_.vertices[model_.vertices[here.previous].boundary_next].boundary_next};
  }

  // Returns the vertices without those at the position of the one before.
  std::vector<VertexIndex> distinct(VertexIndex first, int size) const {
    std::vector<VertexIndex> ring;
    for (VertexIndex v : IndexRange<VertexIndex>{first, {first.value + size}})
      if (at(v) != at(model_.vertices[v].previous)) ring.push_back(v);
    return ring;
  }

  // Joins the hole nearest to the ring by a cut there and back that crosses nothing. Returns false if no such cut
  // exists.
  bool bridge(ConvexPiece& ring, std::vector<ConvexPiece>& holes) const {
    std::size_t hole = 0, from = 0, to = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t h = 0; h < holes.size(); ++h) {
      for (std::size_t i = 0; i < ring.corners.size(); ++i) {
        for (std::size_t k = 0; k < holes[h].corners.size(); ++k) {
          const double size = distance(corner(ring, i), corner(holes[h], k));
          if (size >= least || !in_cone(ring, i, corner(holes[h], k)) || !in_cone(holes[h], k, corner(ring, i)))
            continue;
          const Segment way{corner(ring, i), corner(holes[h], k)};
          const auto is_hit = [&](const ConvexPiece& loop) { return meets(loop, way); };
          if (is_hit(ring) || std::ranges::any_of(holes, is_hit)) continue;
          least = size;
          hole = h;
          from = i;
          to = k;
        }
      }
    }
    if (std::isinf(least)) return false;
    ConvexPiece joined;
    const auto add = [&](const ConvexPiece& loop, std::size_t i, bool starts_cut = false) {
      joined.corners.push_back(loop.corners[i]);
      joined.is_inner.push_back(starts_cut || loop.is_inner[i]);
      joined.is_reflex.push_back(loop.is_reflex[i]);
    };
    for (std::size_t i = 0; i <= from; ++i) add(ring, i, i == from);
    const ConvexPiece& other = holes[hole];
    for (std::size_t k = 0; k < other.corners.size(); ++k) add(other, wrapped(other, to + k));
    add(other, to, true);
    for (std::size_t i = from; i < ring.corners.size(); ++i) add(ring, i);
    ring = std::move(joined);
    holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(hole));
    return true;
  }

  // Returns true if a loop meets a segment at other points than its ends.
  bool meets(const ConvexPiece& loop, const Segment& way) const {
    for (std::size_t i = 0; i < loop.corners.size(); ++i) {
      const Segment edge{corner(loop, i), corner(loop, i + 1)};
      if (edge.start == way.start || edge.start == way.end || edge.end == way.start || edge.end == way.end) continue;
      if (meeting(way, edge) != Meeting::none) return true;
    }
    return false;
  }

  // Returns true if a corner sees a point between its edges. Where a cut joins a hole, two corners share one place and
  // each has its own side.
  bool in_cone(const ConvexPiece& p, std::size_t i, Point target) const {
    const Point here = corner(p, i);
    const Point before = corner(p, i + p.corners.size() - 1) - here;
    const Point after = corner(p, i + 1) - here;
    const Point way = target - here;
    if (cross(before, after) < 0) return cross(after, way) > 0 && cross(way, before) > 0;
    return !(cross(before, way) >= 0 && cross(way, after) >= 0);
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

  // Returns corners first … last, closed by the diagonal.
  static ConvexPiece part(const ConvexPiece& piece, std::size_t first, std::size_t last) {
    ConvexPiece result;
    for (std::size_t i = first;; i = wrapped(piece, i + 1)) {
      result.corners.push_back(piece.corners[i]);
      result.is_inner.push_back(i == last || piece.is_inner[i]);
      result.is_reflex.push_back(piece.is_reflex[i]);
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

  // Effect of a diagonal on the reflex corner at its start. A straight corner would leave an inner and an outer edge on
  // one line, and contact could not tell whose face it is.
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
      if (i == from || i == to || next == from || next == to || has_bridges_) continue;
      if (meeting(diagonal, {corner(piece, i), corner(piece, next)}) != Meeting::none) return false;
    }
    if (has_bridges_ && (!in_cone(piece, from, corner(piece, to)) || !in_cone(piece, to, corner(piece, from)) ||
                         meets(piece, diagonal)))
      return false;
    return side(loop, point_at(diagonal, 0.5)) == Side::inside;
  }

  const Model& model_;
  bool has_bridges_ = false;
  ConvexPieces pieces_;
};

}  // namespace

ConvexPieces convex_pieces(const Model& model, ElementIndex e) {
  return Cutter(model).run(model.elements[e]);
}

}  // namespace keyblock
