// Groups contacts by bodies and joint; see joint_pieces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/columns/joint_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include "formats/columns/column_filler.hpp"

namespace keyblock::formats {
namespace {

struct Piece {
  int block = 0;
  int other = 0;
  int joint_material = 0;
  int joint = 0;
  int contacts = 0;
  int closed = 0;
  int sliding = 0;
  double normal_force = 0;
  double shear_force = 0;
  double greatest_gap = 0;
  double greatest_slip = 0;
  Point tangent;   ///< of the first contact
  Ends ends = {};  ///< first and last contact along the tangent
};

/// Columns of contacts, found once.
struct ContactColumns {
  explicit ContactColumns(const FramePart& part)
      : block(part.at("block").integers()),
        other(part.at("other").integers()),
        material(part.at("joint_material").integers()),
        joint(part.at("joint").integers()),
        state(part.at("state").integers()),
        place(part.at("place").reals()),
        normal(part.at("normal").reals()),
        normal_force(part.at("normal_force").reals()),
        shear_force(part.at("shear_force").reals()),
        gap(part.at("gap").reals()),
        slip(part.at("slip").reals()) {}

  std::span<const int> block, other, material, joint, state;
  std::span<const double> place, normal, normal_force, shear_force, gap, slip;
};

Point point_of(std::span<const double> numbers, std::size_t row) {
  return {numbers[2 * row], numbers[2 * row + 1]};
}

void add_contact(Piece& piece, const ContactColumns& of, std::size_t i) {
  const Point at = point_of(of.place, i);
  if (piece.contacts == 0) {
    const Point normal = point_of(of.normal, i);
    piece.tangent = {-normal.y, normal.x};
    piece.ends = {at, at};
  }
  const auto along = [&](const Point& p) { return dot(p, piece.tangent); };
  if (along(at) < along(piece.ends[0])) piece.ends[0] = at;
  if (along(at) > along(piece.ends[1])) piece.ends[1] = at;
  ++piece.contacts;
  piece.closed += of.state[i] != 0 ? 1 : 0;
  piece.sliding += of.state[i] == 2 ? 1 : 0;
  piece.normal_force += of.normal_force[i];
  piece.shear_force += of.shear_force[i];
  piece.greatest_gap = std::max(piece.greatest_gap, of.gap[i]);
  if (std::abs(of.slip[i]) > std::abs(piece.greatest_slip)) piece.greatest_slip = of.slip[i];
}

std::vector<Piece> pieces_of(const FramePart& contacts) {
  if (contacts.rows == 0) return {};  // such a part has no columns
  const ContactColumns of(contacts);
  std::map<std::tuple<int, int, int, int>, Piece> pieces;
  for (std::size_t i = 0; i < contacts.rows; ++i) {
    const auto [low, high] = std::minmax({of.block[i], of.other[i]});
    Piece& piece = pieces[{low, high, of.joint[i], of.material[i]}];
    piece.block = low;
    piece.other = high;
    piece.joint_material = of.material[i];
    piece.joint = of.joint[i];
    add_contact(piece, of, i);
  }
  std::vector<Piece> all;
  all.reserve(pieces.size());
  for (const auto& [key, piece] : pieces) all.push_back(piece);
  return all;
}

}  // namespace

FramePart joint_pieces(const FramePart& contacts) {
  using P = const Piece&;
  const std::vector<Piece> pieces = pieces_of(contacts);
  FramePart part{"joints", pieces.size(), {}};
  const ColumnFiller fill(part, pieces);
  fill.integer("block", [](P p, std::size_t) { return p.block; });
  fill.integer("other", [](P p, std::size_t) { return p.other; });
  fill.integer("joint_material", [](P p, std::size_t) { return p.joint_material; });
  fill.integer("joint", [](P p, std::size_t) { return p.joint; });
  fill.integer("contacts", [](P p, std::size_t) { return p.contacts; });
  fill.integer("closed", [](P p, std::size_t) { return p.closed; });
  fill.integer("sliding", [](P p, std::size_t) { return p.sliding; });
  fill.real("normal_force", [](P p) { return p.normal_force; });
  fill.real("shear_force", [](P p) { return p.shear_force; });
  fill.real("greatest_gap", [](P p) { return p.greatest_gap; });
  fill.real("greatest_slip", [](P p) { return p.greatest_slip; });
  fill.ends("ends", [](P p) { return p.ends; });
  return part;
}

}  // namespace keyblock::formats
