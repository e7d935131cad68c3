// Rigid motions against the directions held; see free_pieces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/free_pieces.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>

#include "base/union_find.hpp"
#include "geometry/box.hpp"

namespace keyblock {
namespace {

// Of the sum of squares of a motion at all held places; a straight side held along itself hinders no turn to round-off.
constexpr double kHindered = 1e-12;
constexpr double kShown = 1e-3;

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
  for (const auto& [first, piece] : pieces) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(piece.hindered);
    const double greatest = modes.eigenvalues()(2);
    if (modes.eigenvalues()(0) > kHindered * greatest && greatest > 0) continue;
    free.push_back({piece.body, piece.box.middle(), modes.eigenvectors().col(0)});
  }
  return free;
}

std::string to_string(const FreePiece& piece) {
  const Point shift{piece.way(0), piece.way(1)};
  const bool shifts = length(shift) > kShown;
  const bool turns = std::abs(piece.way(2)) > kShown;
  std::string how;
  // A sign is of no meaning, nor is a zero's.
  const auto shown = [](double value) { return std::abs(value) < kShown ? 0.0 : value; };
  const double sign = (shift.x < -kShown || (std::abs(shift.x) <= kShown && shift.y < 0) ? -1 : 1) / length(shift);
  if (shifts) how = fmt::format("move along ({:.3g}, {:.3g})", shown(sign * shift.x), shown(sign * shift.y));
  if (turns) how += shifts ? ", turning" : "turn";
  return fmt::format("body {}, about ({:.6g}, {:.6g}), can {}: nothing holds it there", piece.body + 1, piece.middle.x,
                     piece.middle.y, how);
}

}  // namespace keyblock
