// pugixml finds the arrays; their numbers are split here.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtu_reading.hpp"

#include <fmt/format.h>

#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "formats/text/numbers.hpp"
#include "formats/text/tokens.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::formats {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

class VtuReader {
 public:
  explicit VtuReader(const Source& source) : source_(source) {}

  FieldFrame read() {
    const auto result = document_.load_buffer(source_.text.data(), source_.text.size());
    if (!result) refuse(result.offset, "well-formed XML", result.description());
    piece_ = document_.child("VTKFile").child("UnstructuredGrid").child("Piece");
    if (!piece_) throw InputError({source_.name}, "expected a frame that a run wrote (.vtu), found another file");
    read_arrays();
    FieldFrame field;
    const pugi::xml_node times = document_.child("VTKFile").child("UnstructuredGrid").child("FieldData");
    field.time = numbers(array_of(times, "TimeValue"), 1)[0];
    field.is_of_blocks = !bodies_;
    const std::vector<double> ends = numbers(array_of(piece_.child("Cells"), "offsets"));
    std::size_t first = 0;
    for (std::size_t e = 0; e < ends.size(); ++e) {
      const std::size_t last = index(ends[e], order_.size() + 1, "offsets");
      if (last <= first) refuse_array("offsets", "offsets that rise");
      field.elements.push_back(element(e, first, last));
      first = last;
    }
    return field;
  }

 private:
  [[noreturn]] void refuse(std::ptrdiff_t offset, std::string_view expected, std::string_view found) const {
    const TextMap map(source_.name, source_.text);
    throw InputError(map.place(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0))),
                     fmt::format("expected {}, found {}", expected, found));
  }
  [[noreturn]] void refuse_array(std::string_view name, std::string_view expected) const {
    throw InputError({source_.name}, fmt::format("expected {} in the array {}, found others", expected, name));
  }

  // "stress_xx [Pa]" is found by "stress_xx".
  static std::optional<pugi::xml_node> array_in(const pugi::xml_node parent, std::string_view name) {
    for (const pugi::xml_node array : parent.children("DataArray")) {
      const std::string_view title = array.attribute("Name").value();
      if (title.substr(0, title.find(" [")) == name) return array;
    }
    return std::nullopt;
  }
  pugi::xml_node array_of(const pugi::xml_node parent, std::string_view name) const {
    if (const auto found = array_in(parent, name)) return *found;
    refuse(parent ? parent.offset_debug() : 0, fmt::format("the array {}", name), "none");
  }

  // `count`: how many are wanted; none where any number is good.
  std::vector<double> numbers(const pugi::xml_node array, std::optional<std::size_t> count = std::nullopt) const {
    std::vector<double> values;
    std::string_view text = array.text().get();
    while (true) {
      text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
      if (text.empty()) break;
      const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
      const std::optional<double> value = parse_real(word);
      if (!value) refuse(array.offset_debug(), "finite numbers in the array", in_quotes(word));
      values.push_back(*value);
      text.remove_prefix(word.size());
    }
    if (count && values.size() != *count)
      refuse(array.offset_debug(), fmt::format("{} numbers in the array", *count), fmt::format("{}", values.size()));
    return values;
  }
  std::size_t index(double value, std::size_t end, std::string_view name) const {
    if (!(value >= 0 && value < static_cast<double>(end)) || !is_whole(value)) refuse_array(name, "numbers of others");
    return static_cast<std::size_t>(value);
  }

  struct Stresses {
    std::vector<double> xx, yy, xy, zz;
    Stress at(std::size_t i) const { return {xx[i], yy[i], xy[i], zz[i]}; }
  };
  Stresses stresses(const pugi::xml_node parent, std::size_t count) const {
    const auto part = [&](std::string_view name) { return numbers(array_of(parent, name), count); };
    return {part("stress_xx"), part("stress_yy"), part("stress_xy"), part("stress_zz")};
  }

  void read_arrays() {
    const pugi::xml_node points = piece_.child("PointData"), cells = piece_.child("CellData");
    positions_ = numbers(array_of(piece_.child("Points"), "Points"));
    displacements_ = numbers(array_of(points, "displacement"), positions_.size());
    const std::size_t corners = positions_.size() / 3;
    for (const double number : numbers(array_of(piece_.child("Cells"), "connectivity")))
      order_.push_back(index(number, corners, "connectivity"));
    materials_ = numbers(array_of(cells, "material"));
    const std::size_t elements = materials_.size();
    moves_ = numbers(array_of(cells, "displacement"), 3 * elements);
    in_middles_ = stresses(cells, elements);
    if (const auto bodies = array_in(cells, "body")) {
      bodies_ = numbers(*bodies, elements);
      at_corners_ = stresses(points, corners);
    }
  }

  FieldElement element(std::size_t e, std::size_t first, std::size_t last) const {
    if (e >= materials_.size()) refuse_array("offsets", "as many numbers as cells");
    FieldElement element;
    element.body = bodies_ ? static_cast<int>((*bodies_)[e]) - 1 : static_cast<int>(e);
    element.material = static_cast<int>(materials_[e]) - 1;
    std::vector<Point> drawn;
    auto& loop = element.loops.emplace_back();
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t p = order_[i];
      const Point moved{displacements_[3 * p], displacements_[3 * p + 1]};
      const Point at = Point{positions_[3 * p], positions_[3 * p + 1]} - moved;
      loop.push_back({at, moved, bodies_ ? at_corners_.at(p) : in_middles_.at(e)});
      drawn.push_back(at);
    }
    element.middle = {centroid(drawn), {moves_[3 * e], moves_[3 * e + 1]}, in_middles_.at(e)};
    return element;
  }

  const Source& source_;
  pugi::xml_document document_;
  pugi::xml_node piece_;
  std::vector<double> positions_;  ///< three a corner, where it is now
  std::vector<double> displacements_;
  std::vector<std::size_t> order_;  ///< corners of one element after another
  std::vector<double> materials_;   ///< one a cell, as are those below
  std::vector<double> moves_;
  std::optional<std::vector<double>> bodies_;
  Stresses in_middles_;
  Stresses at_corners_;  ///< where bodies consist of elements
};

}  // namespace

FieldFrame read_vtu(const Source& source) {
  return VtuReader(source).read();
}

}  // namespace keyblock::formats
