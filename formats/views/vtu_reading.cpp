// Reads arrays of the one piece; turns chains around holes back into loops.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtu_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "formats/views/vtk_piece.hpp"
#include "geometry/polygon.hpp"
#include "problem/units/unit_conversion.hpp"

namespace keyblock::formats {
namespace {

using Corners = std::vector<FieldCorner>;

bool is_same(const FieldCorner& a, const FieldCorner& b) {
  return a.position == b.position && a.displacement == b.displacement;
}

/// Walk that `vtu` inserted: from a corner to a corner of a hole, round the hole, and back to both. The shortest walk
/// contains no other.
struct Walk {
  std::size_t first = 0;  ///< the corner at which it begins
  std::size_t last = 0;   ///< the same corner, at its end
};

std::optional<Walk> shortest_walk(const Corners& chain) {
  constexpr std::size_t kLeast = 5;  // to three corners, and back to the first of them
  std::optional<Walk> found;
  for (std::size_t i = 0; i < chain.size(); ++i)
    for (std::size_t j = i + kLeast; j < chain.size() && (!found || j - i < found->last - found->first); ++j)
      if (is_same(chain[i], chain[j]) && is_same(chain[i + 1], chain[j - 1])) found = Walk{i, j};
  return found;
}

std::vector<Corners> loops_of_chain(Corners chain) {
  std::vector<Corners> holes;
  while (const auto walk = shortest_walk(chain)) {
    const auto at = [&](std::size_t i) { return chain.begin() + static_cast<std::ptrdiff_t>(i); };
    holes.emplace_back(at(walk->first + 1), at(walk->last - 1));
    chain.erase(at(walk->first + 1), at(walk->last + 1));
  }
  std::vector<Corners> loops{std::move(chain)};
  loops.insert(loops.end(), holes.rbegin(), holes.rend());
  return loops;
}

Point middle_of(const std::vector<Corners>& loops) {
  Point sum;
  double whole = 0;
  for (const Corners& loop : loops) {
    std::vector<Point> drawn;
    for (const FieldCorner& corner : loop) drawn.push_back(corner.position);
    if (loops.size() == 1) return centroid(drawn);
    const double part = area(drawn);  // negative for holes
    sum = sum + part * centroid(drawn);
    whole += part;
  }
  return whole == 0 ? loops[0][0].position : (1 / whole) * sum;
}

constexpr int kMost = std::numeric_limits<int>::max();

class VtuReader {
 public:
  VtuReader(const Source& source, std::span<const std::string_view> wanted)
      : piece_(source, "UnstructuredGrid"), wanted_(wanted) {}

  VtuFrame read() {
    VtuFrame frame;
    frame.field.time = piece_.time();
    frame.stage = {piece_.field_text("Stage"), piece_.field_number("IsStatic") == 1, piece_.field_number("LoadFactor")};
    read_points();
    read_cells(frame);
    frame.units = units();
    for (const std::string_view name : wanted_) add_values(frame, name);
    return frame;
  }

 private:
  Units units() const {
    Units units;
    units.length = piece_.unit("CellData", "displacement");
    const std::string velocity = piece_.unit("CellData", "velocity");
    if (velocity.starts_with(units.length + "/")) units.time = velocity.substr(units.length.size() + 1);
    const std::string stress = piece_.unit("CellData", "stress_xx");
    if (!stress.empty()) units.mass = mass_of_stress(stress, units.length, units.time);
    return units;
  }

  struct Stresses {
    VtkArray xx, yy, xy, zz;

    Stress at(std::size_t i) const { return {xx[i], yy[i], xy[i], zz[i]}; }
  };
  Stresses stresses_in(std::string_view section, std::size_t count) const {
    return {piece_.at(section, "stress_xx").of(count), piece_.at(section, "stress_yy").of(count),
            piece_.at(section, "stress_xy").of(count), piece_.at(section, "stress_zz").of(count)};
  }

  void read_points() {
    const VtkArray places = piece_.at("Points", "Points");
    const std::size_t count = places.size() / 3;
    const VtkArray moves = piece_.at("PointData", "displacement").of(places.size());
    std::optional<Stresses> stresses;
    if (piece_.find("PointData", "stress_xx")) stresses = stresses_in("PointData", count);
    has_stress_ = stresses.has_value();
    std::optional<VtkArray> plastic;
    if (!wanted_.empty()) plastic = piece_.find("PointData", "equivalent_plastic_strain");
    for (std::size_t p = 0; p < count; ++p) {
      const Point moved{moves[3 * p], moves[3 * p + 1]};
      corners_.push_back(
          {Point{places[3 * p], places[3 * p + 1]} - moved, moved, stresses ? stresses->at(p) : Stress{}});
      if (plastic) corners_.back().plastic.emplace().equivalent = (*plastic)[p];
    }
  }

  void read_cells(VtuFrame& frame) const {
    const VtkArray order = piece_.at("Cells", "connectivity");
    const VtkArray ends = piece_.at("Cells", "offsets");
    const std::size_t count = ends.size();
    const VtkArray numbers = piece_.at("CellData", "block").of(count);
    const VtkArray materials = piece_.at("CellData", "material").of(count);
    const VtkArray moves = piece_.at("CellData", "displacement").of(3 * count);
    const Stresses stresses = stresses_in("CellData", count);
    const std::optional<VtkArray> bodies = piece_.find("CellData", "body");
    if (bodies) VtkArray(*bodies).of(count);
    frame.field.is_of_blocks = !bodies;
    int first = 0;
    for (std::size_t e = 0; e < count; ++e) {
      const int last = ends.whole(e, first + 1, static_cast<int>(std::min<std::size_t>(order.size(), kMost)));
      FieldElement& element = frame.field.elements.emplace_back();
      element.body = bodies ? bodies->whole(e, 1, kMost) - 1 : static_cast<int>(e);
      element.material = materials.whole(e, 1, kMost) - 1;
      element.loops = loops_of_chain(chain(order, first, last));
      element.middle = {middle_of(element.loops), {moves[3 * e], moves[3 * e + 1]}, stresses.at(e)};
      if (!has_stress_)
        for (Corners& loop : element.loops)
          for (FieldCorner& corner : loop) corner.stress = element.middle.stress;
      frame.numbers.push_back(numbers.whole(e, 1, kMost) - 1);
      first = last;
    }
    frame.has_corner_stress = has_stress_;
    frame.field.is_uniform = !has_stress_;
  }

  Corners chain(const VtkArray& order, int first, int last) const {
    Corners chain;
    for (int i = first; i < last; ++i)
      chain.push_back(corners_.at(static_cast<std::size_t>(
          order.whole(static_cast<std::size_t>(i), 0, static_cast<int>(corners_.size()) - 1))));
    return chain;
  }

  void add_values(VtuFrame& frame, std::string_view name) const {
    const auto found = piece_.find("CellData", name);
    const std::size_t rows = frame.numbers.size();
    if (!found || rows == 0) return;
    const std::size_t width = found->size() == 3 * rows ? 3 : 1;
    frame.values.push_back(
        {std::string(name), piece_.unit("CellData", name), width, VtkArray(*found).of(width * rows).numbers()});
  }

  VtkPiece piece_;
  std::span<const std::string_view> wanted_;
  Corners corners_;          ///< of all elements
  bool has_stress_ = false;  ///< of the corners; otherwise they have that of their element
};

}  // namespace

VtuFrame read_vtu(const Source& source, std::span<const std::string_view> wanted) {
  return VtuReader(source, wanted).read();
}

}  // namespace keyblock::formats
