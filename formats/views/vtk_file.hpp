// Writes and reads a VTK XML file of one piece: the description of its arrays and their bytes.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// raw: the numbers of all arrays follow the XML in <AppendedData encoding="raw">, each array after its number of bytes
// (UInt64, little endian). zlib: the same, in blocks packed by zlib (vtkZLibDataCompressor). text: numbers as text in
// the XML, with the fewest digits that give the same number back. automatic: raw if points are few; else blocks of
// zlib, of which only those of integers and vectors other than places are packed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/format.hpp"
#include "geometry/point.hpp"

namespace keyblock::formats {

enum class VtkCoding { automatic, raw, zlib, text };

/// Returns "automatic", "raw", "zlib", "text".
std::vector<std::string> vtk_coding_names();
/// Throws std::invalid_argument for another word.
VtkCoding vtk_coding_of(std::string_view name);

/// Gives level and strategy with which zlib packs an array.
struct VtkPacking {
  int level;
  int strategy;
};

/// Returns a field of the whole file: a number, or a text as VTK keeps it, by the codes of its bytes.
std::string vtk_field(std::string_view name, double number);
std::string vtk_field(std::string_view name, std::string_view text);

/// VTK file under construction; arrays are added in the order in which viewers list them.
class VtkFile {
 public:
  /// `grid`: "UnstructuredGrid" or "PolyData"; `fields` as `vtk_field` gives them; `counts`: the attributes of its
  /// piece, which has `points`.
  VtkFile(std::string_view grid, std::string_view fields, std::string_view counts, std::size_t points,
          VtkCoding coding);

  /// Begins an element that holds arrays: "PointData".
  void begin(std::string_view section);
  void end();

  /// Adds an array with rows of `width` numbers.
  void add(std::string_view name, std::span<const double> values, int width = 1);
  void add(std::string_view name, std::span<const float> values, int width = 1);
  void add(std::string_view name, std::span<const std::int32_t> values, int width = 1);
  void add(std::string_view name, std::span<const std::uint8_t> values, int width = 1);

  /// Adds the section Points, from places in the plane.
  void add_points(std::span<const Point> places);

  VtkFile(const VtkFile&) = delete;
  VtkFile& operator=(const VtkFile&) = delete;
  ~VtkFile();

  std::string text() &&;

 private:
  template <class T>
  void add_values(std::string_view name, std::span<const T> values, int width);
  void append(std::span<const std::uint8_t> bytes, const VtkPacking& packing);

  class Packer;

  std::string grid_;
  VtkCoding coding_;
  std::string xml_;
  std::string section_;
  std::string appended_;
  std::unique_ptr<Packer> packer_;  ///< if blocks are packed
};

/// XML of a VTK file, and the bytes after it. `vtk_parts_of` throws InputError if those do not begin as required.
struct VtkParts {
  Source xml;
  std::string_view appended;  ///< empty in a text file; refers to the source
  bool is_packed = false;     ///< by zlib
};
VtkParts vtk_parts_of(const Source& source);
VtkParts vtk_parts_of(Source&&) = delete;

/// Returns the numbers of type "Float64", "Float32", "Int64", "Int32" or "UInt8" that begin at `offset`. Throws
/// InputError with `place` if bytes are missing, if zlib cannot unpack them, or for another type.
std::vector<double> vtk_numbers(const VtkParts& parts, std::string_view type, std::string_view offset,
                                const Place& place);

}  // namespace keyblock::formats
