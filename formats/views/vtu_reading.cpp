// Reads arrays of the one piece; turns chains around holes back into loops.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtu_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "formats/text/tokens.hpp"
#include "formats/xml/xml_document.hpp"
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

/// Numbers of an array; those of a text know their places.
class VtuArray {
 public:
  VtuArray(const Element& element, std::string_view name, const VtkParts& parts)
      : name_(name), place_(element.place()) {
    const auto attribute = [&](const char* word) {
      const auto found = element.attribute(word);
      return found ? found->value : std::string_view();
    };
    if (attribute("format") == "appended") {
      numbers_ = vtk_numbers(parts, attribute("type"), attribute("offset"), place_);
      if (!std::ranges::all_of(numbers_, [](double number) { return std::isfinite(number); }))
        throw InputError(place_, fmt::format("expected finite numbers in the array {}, found others", name));
      return;
    }
    tokens_ = element.tokens();
    if (const auto junk = tokens_->junk())
      throw InputError(tokens_->place_of(tokens_->numbers.size()),
                       fmt::format("expected a finite number in the array {}, found {}", name, in_quotes(*junk)));
    numbers_.assign(tokens_->numbers.begin(), tokens_->numbers.end());
  }

  std::size_t size() const { return numbers_.size(); }
  double operator[](std::size_t i) const { return numbers_[i]; }

  /// Throws InputError unless the array has `count` numbers.
  VtuArray&& of(std::size_t count) && {
    if (size() != count)
      throw InputError(place_, fmt::format("expected {} numbers in the array {}, found {}", count, name_, size()));
    return std::move(*this);
  }
  /// Returns a whole number from `least` to `most`. Throws InputError for others.
  int whole(std::size_t i, int least, int most) const {
    const double value = numbers_[i];
    if (!is_whole(value) || value < least || value > most)
      throw InputError(tokens_ ? tokens_->place_of(i) : place_,
                       fmt::format("expected a whole number from {} to {} in the array {}, found {}", least, most,
                                   name_, tokens_ ? in_quotes(tokens_->word(i)) : fmt::format("{}", value)));
    return static_cast<int>(value);
  }

 private:
  std::string name_;
  Place place_;
  std::optional<Tokens> tokens_;
  std::vector<double> numbers_;
};

std::optional<Element> child_of(const Element& parent, std::string_view name) {
  for (const Element& child : parent.children())
    if (child.name() == name) return child;
  return std::nullopt;
}

class VtuReader {
 public:
  explicit VtuReader(const Source& source) : parts_(vtk_parts_of(source)), document_(parts_.xml) {}

  VtuFrame read() {
    require_known_bytes();
    const Element grid = inner(document_.root(), "UnstructuredGrid");
    const Element piece = inner(grid, "Piece");
    VtuFrame frame;
    frame.field.time = array(inner(grid, "FieldData"), "TimeValue").of(1)[0];
    read_points(piece);
    read_cells(piece, frame);
    frame.units = units_in(inner(piece, "CellData"));
    return frame;
  }

 private:
  static constexpr int kMost = std::numeric_limits<int>::max();

  // Reads only bytes that `VtkFile` could have written.
  void require_known_bytes() const {
    if (parts_.appended.empty()) return;
    const auto require = [&](const char* word, std::string_view wanted) {
      const auto found = document_.root().attribute(word);
      if (found && found->value != wanted)
        throw InputError(found->place,
                         fmt::format("expected {}=\"{}\", found {}", word, wanted, in_quotes(found->value)));
    };
    require("byte_order", "LittleEndian");
    require("header_type", "UInt64");
    if (!parts_.is_packed) require("compressor", "vtkZLibDataCompressor");
  }

  static Element inner(const Element& parent, std::string_view name) {
    if (const auto found = child_of(parent, name)) return *found;
    throw InputError(parent.place(), fmt::format("expected {} of a frame that a run wrote (.vtu), found none", name));
  }
  // "stress_xx" finds "stress_xx [Pa]".
  std::optional<VtuArray> array_in(const Element& parent, std::string_view name) const {
    for (const Element& child : parent.children()) {
      const auto title = child.attribute("Name");
      if (title && title->value.substr(0, title->value.find(" [")) == name) return VtuArray(child, name, parts_);
    }
    return std::nullopt;
  }
  VtuArray array(const Element& parent, std::string_view name) const {
    if (auto found = array_in(parent, name)) return std::move(*found);
    throw InputError(parent.place(), fmt::format("expected the array {}, found none", name));
  }

  /// Returns "Pa" for "stress_xx [Pa]".
  static std::string unit_in(const Element& parent, std::string_view name) {
    for (const Element& child : parent.children()) {
      const auto title = child.attribute("Name");
      const std::string start = fmt::format("{} [", name);
      if (title && title->value.starts_with(start) && title->value.ends_with("]"))
        return std::string(title->value.substr(start.size(), title->value.size() - start.size() - 1));
    }
    return {};
  }
  static Units units_in(const Element& data) {
    Units units;
    units.length = unit_in(data, "displacement");
    const std::string velocity = unit_in(data, "velocity");
    if (velocity.starts_with(units.length + "/")) units.time = velocity.substr(units.length.size() + 1);
    const std::string stress = unit_in(data, "stress_xx");
    if (!stress.empty()) units.mass = mass_of_stress(stress, units.length, units.time);
    return units;
  }

  struct Stresses {
    VtuArray xx, yy, xy, zz;

    Stress at(std::size_t i) const { return {xx[i], yy[i], xy[i], zz[i]}; }
  };
  Stresses stresses_in(const Element& parent, std::size_t count) const {
    return {array(parent, "stress_xx").of(count), array(parent, "stress_yy").of(count),
            array(parent, "stress_xy").of(count), array(parent, "stress_zz").of(count)};
  }

  void read_points(const Element& piece) {
    const VtuArray places = array(inner(piece, "Points"), "Points");
    const Element data = inner(piece, "PointData");
    const VtuArray moves = array(data, "displacement").of(places.size());
    std::optional<Stresses> stresses;
    if (array_in(data, "stress_xx")) stresses = stresses_in(data, places.size() / 3);
    has_stress_ = stresses.has_value();
    for (std::size_t p = 0; p < places.size() / 3; ++p) {
      const Point moved{moves[3 * p], moves[3 * p + 1]};
      corners_.push_back(
          {Point{places[3 * p], places[3 * p + 1]} - moved, moved, stresses ? stresses->at(p) : Stress{}});
    }
  }

  void read_cells(const Element& piece, VtuFrame& frame) const {
    const Element cells = inner(piece, "Cells"), data = inner(piece, "CellData");
    const VtuArray order = array(cells, "connectivity");
    const VtuArray ends = array(cells, "offsets");
    const std::size_t count = ends.size();
    const VtuArray numbers = array(data, "block").of(count), materials = array(data, "material").of(count);
    const VtuArray moves = array(data, "displacement").of(3 * count);
    const Stresses stresses = stresses_in(data, count);
    const std::optional<VtuArray> bodies = array_in(data, "body");
    if (bodies) VtuArray(*bodies).of(count);
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
  }

  Corners chain(const VtuArray& order, int first, int last) const {
    Corners chain;
    for (int i = first; i < last; ++i)
      chain.push_back(corners_.at(static_cast<std::size_t>(
          order.whole(static_cast<std::size_t>(i), 0, static_cast<int>(corners_.size()) - 1))));
    return chain;
  }

  VtkParts parts_;
  Document document_;
  Corners corners_;          ///< of all elements
  bool has_stress_ = false;  ///< of the corners; otherwise they have that of their element
};

}  // namespace

VtuFrame read_vtu(const Source& source) {
  return VtuReader(source).read();
}

}  // namespace keyblock::formats
