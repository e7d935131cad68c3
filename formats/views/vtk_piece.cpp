// Finds sections and arrays by name; see vtk_piece.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtk_piece.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "formats/text/csv.hpp"

namespace keyblock::formats {
namespace {

std::optional<Element> child_of(const Element& parent, std::string_view name) {
  for (const Element& child : parent.children())
    if (child.name() == name) return child;
  return std::nullopt;
}

}  // namespace

VtkArray::VtkArray(const Element& element, std::string_view name, const VtkParts& parts)
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

VtkArray&& VtkArray::of(std::size_t count) && {
  if (size() != count)
    throw InputError(place_, fmt::format("expected {} numbers in the array {}, found {}", count, name_, size()));
  return std::move(*this);
}

int VtkArray::whole(std::size_t i, int least, int most) const {
  const double value = numbers_[i];
  if (!is_whole(value) || value < least || value > most)
    throw InputError(tokens_ ? tokens_->place_of(i) : place_,
                     fmt::format("expected a whole number from {} to {} in the array {}, found {}", least, most, name_,
                                 tokens_ ? in_quotes(tokens_->word(i)) : fmt::format("{}", value)));
  return static_cast<int>(value);
}

VtkPiece::VtkPiece(const Source& source, std::string_view grid)
    : parts_(vtk_parts_of(source)),
      document_(parts_.xml),
      ending_(grid == "PolyData" ? ".vtp" : ".vtu"),
      grid_((require_known_bytes(), inner(document_.root(), grid))),
      piece_(inner(grid_, "Piece")) {}

double VtkPiece::time() const {
  return array(inner(grid_, "FieldData"), "TimeValue").of(1)[0];
}

std::optional<double> VtkPiece::field_number(std::string_view name) const {
  std::optional<VtkArray> found = array_in(inner(grid_, "FieldData"), name);
  return found ? std::optional(std::move(*found).of(1)[0]) : std::nullopt;
}

std::string VtkPiece::field_text(std::string_view name) const {
  const std::optional<VtkArray> codes = array_in(inner(grid_, "FieldData"), name);
  std::string text;
  for (std::size_t i = 0; codes && i < codes->size(); ++i)
    if (const int code = codes->whole(i, 0, 255); code != 0) text += static_cast<char>(code);
  return text;
}

std::optional<VtkArray> VtkPiece::find(std::string_view section, std::string_view name) const {
  const auto found = child_of(piece_, section);
  return found ? array_in(*found, name) : std::nullopt;
}

VtkArray VtkPiece::at(std::string_view section, std::string_view name) const {
  return array(inner(piece_, section), name);
}

std::string VtkPiece::unit(std::string_view section, std::string_view name) const {
  const auto parent = child_of(piece_, section);
  if (!parent) return {};
  const std::string start = fmt::format("{} [", name);
  for (const Element& child : parent->children()) {
    const auto title = child.attribute("Name");
    if (title && title->value.starts_with(start) && title->value.ends_with("]"))
      return std::string(title->value.substr(start.size(), title->value.size() - start.size() - 1));
  }
  return {};
}

void VtkPiece::require_known_bytes() const {
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

Element VtkPiece::inner(const Element& parent, std::string_view name) const {
  if (const auto found = child_of(parent, name)) return *found;
  throw InputError(parent.place(),
                   fmt::format("expected {} of a frame that a run wrote ({}), found none", name, ending_));
}

std::optional<VtkArray> VtkPiece::array_in(const Element& parent, std::string_view name) const {
  for (const Element& child : parent.children()) {
    const auto title = child.attribute("Name");
    if (title && csv_heading(title->value).name == name) return VtkArray(child, name, parts_);
  }
  return std::nullopt;
}

VtkArray VtkPiece::array(const Element& parent, std::string_view name) const {
  if (auto found = array_in(parent, name)) return std::move(*found);
  throw InputError(parent.place(), fmt::format("expected the array {}, found none", name));
}

}  // namespace keyblock::formats
