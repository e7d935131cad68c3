// Groups contacts by bodies and joint; see joint_pieces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/columns/joint_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
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

/// Columns of contacts, read by row.
class ContactRows {
 public:
  explicit ContactRows(const FramePart& part) : part_(part) {}
  int whole(std::string_view name, std::size_t row) const { return part_.at(name).integers()[row]; }
  double real(std::string_view name, std::size_t row) const { return part_.at(name).reals()[row]; }
  Point xy(std::string_view name, std::size_t row) const {
    const std::span<const double> numbers = part_.at(name).reals();
    return {numbers[2 * row], numbers[2 * row + 1]};
  }

 private:
  const FramePart& part_;
};

void add_contact(Piece& piece, const ContactRows& rows, std::size_t i) {
  const Point at = rows.xy("place", i);
  if (piece.contacts == 0) {
    const Point normal = rows.xy("normal", i);
    piece.tangent = {-normal.y, normal.x};
    piece.ends = {at, at};
  }
  const auto along = [&](const Point& p) { return dot(p, piece.tangent); };
  if (along(at) < along(piece.ends[0])) piece.ends[0] = at;
  if (along(at) > along(piece.ends[1])) piece.ends[1] = at;
  const int state = rows.whole("state", i);
  ++piece.contacts;
  piece.closed += state != 0 ? 1 : 0;
  piece.sliding += state == 2 ? 1 : 0;
  piece.normal_force += rows.real("normal_force", i);
  piece.shear_force += rows.real("shear_force", i);
  piece.greatest_gap = std::max(piece.greatest_gap, rows.real("gap", i));
  const double slip = rows.real("slip", i);
  if (std::abs(slip) > std::abs(piece.greatest_slip)) piece.greatest_slip = slip;
}

std::vector<Piece> pieces_of(const FramePart& contacts) {
  const ContactRows rows(contacts);
  std::map<std::tuple<int, int, int, int>, Piece> pieces;
  for (std::size_t i = 0; i < contacts.rows; ++i) {
    const auto [low, high] = std::minmax({rows.whole("block", i), rows.whole("other", i)});
    const int material = rows.whole("joint_material", i);
    const int joint = rows.whole("joint", i);
    Piece& piece = pieces[{low, high, joint, material}];
    piece.block = low;
    piece.other = high;
    piece.joint_material = material;
    piece.joint = joint;
    add_contact(piece, rows, i);
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
