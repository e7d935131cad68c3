// A VTK XML file of one piece: how its arrays are described, and how their bytes are written and read back.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// raw: the numbers of all arrays follow the XML in <AppendedData encoding="raw">, each array behind the count of its
// bytes (UInt64, little endian). zlib: likewise, in blocks that zlib has packed (vtkZLibDataCompressor). text: numbers
// as text in the XML, the shortest that give the same number back.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/format.hpp"
#include "geometry/point.hpp"

namespace keyblock::formats {

enum class VtkCoding { raw, zlib, text };

/// "raw", "zlib", "text".
std::vector<std::string> vtk_coding_names();
/// Throws std::invalid_argument for another word.
VtkCoding vtk_coding_of(std::string_view name);

/// The file as it is made, array after array in the order in which viewers list them.
class VtkFile {
 public:
  /// `grid`: "UnstructuredGrid" or "PolyData"; `counts`: the attributes of its piece.
  VtkFile(std::string_view grid, double time, std::string_view counts, VtkCoding coding);

  /// An element that holds arrays: "PointData".
  void begin(std::string_view section);
  void end();

  /// Rows of `width` numbers.
  void add(std::string_view name, std::span<const double> values, int width = 1);
  void add(std::string_view name, std::span<const float> values, int width = 1);
  void add(std::string_view name, std::span<const std::int32_t> values, int width = 1);
  void add(std::string_view name, std::span<const std::uint8_t> values, int width = 1);

  /// The section Points, of places in the plane.
  void add_points(std::span<const Point> places);

  std::string text() &&;

 private:
  template <class T>
  void add_values(std::string_view name, std::span<const T> values, int width);
  void append(std::span<const std::uint8_t> bytes);

  std::string grid_;
  VtkCoding coding_;
  std::string xml_;
  std::string section_;
  std::string appended_;
};

/// The XML of such a file without the bytes behind it, and those bytes. Throws InputError where they do not begin as
/// they should.
struct VtkParts {
  Source xml;
  std::string_view appended;  ///< empty in a file of text; refers to the source
  bool is_packed = false;     ///< by zlib
};
VtkParts vtk_parts_of(const Source& source);
VtkParts vtk_parts_of(Source&&) = delete;

/// Numbers of type "Float64", "Float32", "Int64", "Int32" or "UInt8" that begin at `offset`. Throws InputError with
/// `place` where there are not so many bytes, where zlib cannot unpack them, or for another type.
std::vector<double> vtk_numbers(const VtkParts& parts, std::string_view type, std::string_view offset,
                                const Place& place);

}  // namespace keyblock::formats
