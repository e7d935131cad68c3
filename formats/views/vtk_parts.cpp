// Writes contacts, joints, bolts and cracks as files of VTK's PolyData.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtk_parts.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <numeric>
#include <string_view>
#include <vector>

#include "formats/columns/joint_sums.hpp"
#include "formats/views/vtk_arrays.hpp"

namespace keyblock::formats {
namespace {

/// Cells of a file: vertices, or lines of two points each.
struct Cells {
  std::string_view word;  ///< Verts, Lines
  std::int32_t size;      ///< points per cell
  std::size_t count;
};

std::size_t points_of(const Cells& cells) {
  return cells.count * static_cast<std::size_t>(cells.size);
}

std::string counts_of(const Cells& cells) {
  return fmt::format("NumberOfPoints=\"{}\" NumberOf{}=\"{}\"", points_of(cells), cells.word, cells.count);
}

std::vector<Point> places_of(const FrameColumn& column) {
  std::vector<Point> places;
  const std::span<const double> numbers = column.reals();
  for (std::size_t i = 0; i < numbers.size(); i += 2) places.push_back({numbers[i], numbers[i + 1]});
  return places;
}

void add_cells(VtkFile& file, const Cells& cells, const FrameColumn& column) {
  const std::vector<Point> places = places_of(column);
  std::vector<std::int32_t> connectivity(places.size()), offsets(cells.count);
  std::iota(connectivity.begin(), connectivity.end(), 0);
  for (std::size_t i = 0; i < cells.count; ++i) offsets[i] = cells.size * static_cast<std::int32_t>(i + 1);
  file.add_points(places);
  file.begin(cells.word);
  file.add("connectivity", connectivity);
  file.add("offsets", offsets);
  file.end();
}

std::string lines_vtp(const FrameColumns& frame, const FramePart& part, const RunTable& table, const Units& units,
                      VtkCoding coding) {
  const Cells cells{"Lines", 2, part.rows};
  VtkFile file("PolyData", vtk_field("TimeValue", frame.time), counts_of(cells), points_of(cells), coding);
  if (part.find("displacement")) {
    file.begin("PointData");
    add_arrays(file, part, table, units, ArraysOf::ends);
    file.end();
  }
  file.begin("CellData");
  add_arrays(file, part, table, units, ArraysOf::rows);
  file.end();
  add_cells(file, cells, part.at("ends"));
  return std::move(file).text();
}

}  // namespace

std::string contacts_vtp(const FrameColumns& frame, const Units& units, VtkCoding coding) {
  const FramePart& part = frame.part("contacts");
  const Cells cells{"Verts", 1, part.rows};
  VtkFile file("PolyData", vtk_field("TimeValue", frame.time), counts_of(cells), points_of(cells), coding);
  file.begin("PointData");
  add_arrays(file, part, kContactArrays, units, ArraysOf::rows);
  file.end();
  add_cells(file, cells, part.at("place"));
  return std::move(file).text();
}

std::string joints_vtp(const FrameColumns& frame, const Units& units, VtkCoding coding) {
  return lines_vtp(frame, joint_part(frame.part("contacts")), kJointArrays, units, coding);
}

std::string bolts_vtp(const FrameColumns& frame, const Units& units, VtkCoding coding) {
  return lines_vtp(frame, frame.part("bolts"), kBoltArrays, units, coding);
}

std::string cracks_vtp(const FrameColumns& frame, const Units& units, VtkCoding coding) {
  return lines_vtp(frame, frame.part("cracks"), kCrackArrays, units, coding);
}

}  // namespace keyblock::formats
