// Compares rigid motions with the supported directions; see free_pieces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/free_pieces.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "base/union_find.hpp"
#include "geometry/box.hpp"

namespace keyblock {
namespace {

// Limit on the sum of squares of a motion at all supported places. A straight side supported along itself resists no
// rotation up to round-off.
constexpr double kHindered = 1e-12;
constexpr double kShown = 1e-3;
constexpr double kRounding = 1e-9;  // per size of coordinates: shown as 0

struct Piece {
  int body = 0;
  Box box;
  Eigen::Matrix3d hindered = Eigen::Matrix3d::Zero();

  double size() const { return length(box.size()); }

  void hold(Point at, Point direction) {
    const Eigen::Vector3d way(direction.x, direction.y, cross(at - box.middle(), direction) / size());
    hindered += way * way.transpose();
  }
};

UnionFind connected(const Manifold& manifold) {
  UnionFind groups(manifold.elements.size());
  for (std::size_t e = 0; e < manifold.elements.size(); ++e) {
    const auto join = [&](const SlotRange& loop) {
      for (const ElementCorner& corner : manifold.loop(loop))
        if (corner.neighbour >= 0) groups.unite(static_cast<int>(e), corner.neighbour);
    };
    join(manifold.elements[e].outer);
    for (const SlotRange& hole : manifold.holes_of(manifold.elements[e])) join(hole);
  }
  return groups;
}

void hold_side(Piece& piece, const ElementSide& side, Held held) {
  for (const Point end : {side.edge.start, side.edge.end}) {
    if (held == Held::normal) piece.hold(end, side.normal());
    if (held == Held::both || held == Held::x) piece.hold(end, {1, 0});
    if (held == Held::both || held == Held::y) piece.hold(end, {0, 1});
  }
}

Point farthest_from(Point from, const std::vector<Point>& points) {
  return *std::ranges::max_element(points, {}, [&](Point p) { return distance(from, p); });
}

/// Faces at which pieces of one body lie side by side, where it is cut through.
class Cuts {
 public:
  Cuts(const Manifold& manifold, UnionFind& groups) : manifold_(manifold), groups_(groups) {
    each_face([&](int element, Point from, Point to) { elements_[{from.x, from.y, to.x, to.y}].push_back(element); });
  }

  /// Returns the two ends, those farthest apart, of all cut faces of the piece of this element.
  std::optional<Segment> of(int piece) {
    std::vector<Point> ends;
    each_face([&](int element, Point from, Point to) {
      if (groups_.find(element) == piece && has_other_side(element, from, to)) ends.insert(ends.end(), {from, to});
    });
    if (ends.empty()) return std::nullopt;
    const Point first = farthest_from(ends.front(), ends);
    const Point last = farthest_from(first, ends);
    const bool is_turned = last.x < first.x || (last.x == first.x && last.y < first.y);
    return is_turned ? Segment{last, first} : Segment{first, last};
  }

 private:
  template <class Visit>
  void each_face(const Visit& visit) const {
    const auto look = [&](int element, std::span<const ElementCorner> loop) {
      for (std::size_t i = 0; i < loop.size(); ++i)
        if (loop[i].neighbour < 0) visit(element, loop[i].position, loop[(i + 1) % loop.size()].position);
    };
    for (std::size_t e = 0; e < manifold_.elements.size(); ++e) {
      look(static_cast<int>(e), manifold_.loop(manifold_.elements[e].outer));
      for (const SlotRange& hole : manifold_.holes_of(manifold_.elements[e]))
        look(static_cast<int>(e), manifold_.loop(hole));
    }
  }

  // The two sides of a face have the same ends, to the bit.
  bool has_other_side(int element, Point from, Point to) {
    const auto found = elements_.find({to.x, to.y, from.x, from.y});
    if (found == elements_.end()) return false;
    const auto body_of = [&](int e) { return manifold_.elements[static_cast<std::size_t>(e)].body; };
    return std::ranges::any_of(found->second, [&](int other) {
      return body_of(other) == body_of(element) && groups_.find(other) != groups_.find(element);
    });
  }

  const Manifold& manifold_;
  UnionFind& groups_;
  std::map<std::array<double, 4>, std::vector<int>> elements_;  // of a face, by its ends
};

}  // namespace

std::vector<FreePiece> free_pieces(const Continuum& continuum) {
  const Manifold& manifold = continuum.manifold;
  UnionFind groups = connected(manifold);
  std::map<int, Piece> pieces;
  for (std::size_t e = 0; e < manifold.elements.size(); ++e) {
    Piece& piece = pieces[groups.find(static_cast<int>(e))];
    piece.body = manifold.elements[e].body;
    for (const ElementCorner& corner : manifold.loop(manifold.elements[e].outer)) piece.box.add(corner.position);
  }
  for (const PrescribedDisplacement& part : continuum.prescribed)
    for (const ElementSide& side : sides_along(manifold, part.along))
      hold_side(pieces[groups.find(side.element)], side, part.held);
  for (const PointSpring& spring : continuum.point_springs)
    pieces[groups.find(spring.element)].hold(spring.at, spring.direction);

  std::vector<FreePiece> free;
  std::vector<int> firsts;  // one element of each piece
  for (const auto& [first, piece] : pieces) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(piece.hindered);
    const double greatest = modes.eigenvalues()(2);
    if (modes.eigenvalues()(0) > kHindered * greatest && greatest > 0) continue;
    free.push_back({piece.body, piece.box.middle(), modes.eigenvectors().col(0)});
    firsts.push_back(first);
  }
  if (free.empty() || pieces.size() == manifold.body_materials.size()) return free;
  Cuts cuts(manifold, groups);
  for (std::size_t i = 0; i < free.size(); ++i) free[i].cut = cuts.of(firsts[i]);
  return free;
}

std::string to_string(const FreePiece& piece) {
  const Point shift{piece.way(0), piece.way(1)};
  const bool shifts = length(shift) > kShown;
  const bool turns = std::abs(piece.way(2)) > kShown;
  std::string how;
  // Neither the sign of the direction nor that of a zero has a meaning.
  const auto shown = [](double value) { return std::abs(value) < kShown ? 0.0 : value; };
  const double sign = (shift.x < -kShown || (std::abs(shift.x) <= kShown && shift.y < 0) ? -1 : 1) / length(shift);
  if (shifts) how = fmt::format("move along ({:.3g}, {:.3g})", shown(sign * shift.x), shown(sign * shift.y));
  if (turns) how += shifts ? ", turning" : "turn";
  const std::string can =
      fmt::format("body {}, about ({:.6g}, {:.6g}), can {}", piece.body + 1, piece.middle.x, piece.middle.y, how);
  if (!piece.cut) return can + ": it has no support";
  const double rounding = kRounding * (length(piece.cut->start) + length(piece.cut->end));
  const auto place = [&](double value) { return std::abs(value) < rounding ? 0.0 : value; };
  return fmt::format(
      "{}: a crack or joint from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) cuts it off from its body, and it has no "
      "support; support this part too, let its faces touch (contact=felt), or end the crack inside",
      can, place(piece.cut->start.x), place(piece.cut->start.y), place(piece.cut->end.x), place(piece.cut->end.y));
}

}  // namespace keyblock
