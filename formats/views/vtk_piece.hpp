// Reads the arrays of a VTK file of one piece. It is not a general reader of VTK: arrays have the coding of `VtkFile`,
// or are text, as earlier versions wrote them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/text/tokens.hpp"
#include "formats/views/vtk_file.hpp"
#include "formats/xml/xml_document.hpp"

namespace keyblock::formats {

/// Numbers of an array; those of a text know their places.
class VtkArray {
 public:
  /// Throws InputError for numbers that are not finite.
  VtkArray(const Element& element, std::string_view name, const VtkParts& parts);

  std::size_t size() const { return numbers_.size(); }
  double operator[](std::size_t i) const { return numbers_[i]; }
  const std::vector<double>& numbers() const { return numbers_; }

  /// Throws InputError unless the array has `count` numbers.
  VtkArray&& of(std::size_t count) &&;
  /// Returns a whole number from `least` to `most`. Throws InputError for others.
  int whole(std::size_t i, int least, int most) const;

 private:
  std::string name_;
  Place place_;
  std::optional<Tokens> tokens_;
  std::vector<double> numbers_;
};

/// The piece of a file. Its sections are "Points", "Cells", "PointData", "CellData", "Lines".
class VtkPiece {
 public:
  /// `grid` is "UnstructuredGrid" or "PolyData". Refers to the source. Throws InputError for other files, and for bytes
  /// that `VtkFile` cannot have written.
  VtkPiece(const Source& source, std::string_view grid);
  VtkPiece(Source&&, std::string_view) = delete;

  double time() const;
  /// Returns a field of the file; nothing, or an empty text, if it has none of that name.
  std::optional<double> field_number(std::string_view name) const;
  std::string field_text(std::string_view name) const;

  /// Finds "stress_xx [Pa]" by "stress_xx". Returns nothing if there is no such section or array.
  std::optional<VtkArray> find(std::string_view section, std::string_view name) const;
  /// Throws InputError if there is no such section or array.
  VtkArray at(std::string_view section, std::string_view name) const;

  /// Returns "Pa" for "stress_xx [Pa]"; empty without a unit.
  std::string unit(std::string_view section, std::string_view name) const;

 private:
  void require_known_bytes() const;
  Element inner(const Element& parent, std::string_view name) const;
  std::optional<VtkArray> array_in(const Element& parent, std::string_view name) const;
  VtkArray array(const Element& parent, std::string_view name) const;

  VtkParts parts_;
  Document document_;
  std::string_view ending_;
  Element grid_;
  Element piece_;
};

}  // namespace keyblock::formats
