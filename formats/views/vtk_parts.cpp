// Files of VTK's PolyData.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtk_parts.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <string_view>
#include <vector>

#include "formats/views/vtk_rows.hpp"

namespace keyblock::formats {
namespace {

/// Points of as many vertices, or of as many lines of two points, which are the cells.
struct Cells {
  std::string_view word;  ///< Verts, Lines
  std::int32_t size;      ///< points of each
  std::size_t count;
};

std::string counts_of(const Cells& cells) {
  return fmt::format("NumberOfPoints=\"{}\" NumberOf{}=\"{}\"", cells.count * static_cast<std::size_t>(cells.size),
                     cells.word, cells.count);
}

void add_cells(VtkFile& file, const Cells& cells, const std::vector<Point>& places) {
  std::vector<std::int32_t> connectivity(places.size()), offsets(cells.count);
  std::iota(connectivity.begin(), connectivity.end(), 0);
  for (std::size_t i = 0; i < cells.count; ++i) offsets[i] = cells.size * static_cast<std::int32_t>(i + 1);
  file.add_points(places);
  file.begin(cells.word);
  file.add("connectivity", connectivity);
  file.add("offsets", offsets);
  file.end();
}

}  // namespace

std::string contacts_vtp(double time, const ContactFrames& contacts, const Units& units, VtkCoding coding) {
  using C = const ContactFrame&;
  const Cells cells{"Verts", 1, contacts.size()};
  VtkFile file("PolyData", time, counts_of(cells), coding);
  VtkRows arrays(file, contacts, kContactArrays, units);
  file.begin("PointData");
  arrays.add<std::int32_t>("block", [](C c, std::size_t) { return c.element + 1; });
  arrays.add<std::int32_t>("other", [](C c, std::size_t) { return c.other + 1; });
  arrays.add<std::int32_t>("joint_material", [](C c, std::size_t) { return c.joint_material + 1; });
  arrays.add<std::int32_t>("joint", [](C c, std::size_t) { return c.joint_line + 1; });
  arrays.add<std::int32_t>("state", [](C c, std::size_t) { return static_cast<int>(c.condition); });
  arrays.add<double>("gap", [](C c, std::size_t) { return c.gap; });
  arrays.add<double>("slip", [](C c, std::size_t) { return c.slip; });
  arrays.add<double>("normal_force", [](C c, std::size_t) { return c.normal_force; });
  arrays.add<double>("shear_force", [](C c, std::size_t) { return c.shear_force; });
  arrays.add_vectors<float>("normal", [](C c) { return std::array{c.normal}; });
  arrays.add_vectors<double>("force", [](C c) { return std::array{c.force()}; });
  file.end();
  std::vector<Point> places;
  for (C c : contacts) places.push_back(c.position);
  add_cells(file, cells, places);
  return std::move(file).text();
}

std::string bolts_vtp(const Frame& frame, const Units& units, VtkCoding coding) {
  using B = const BoltFrame&;
  const Cells cells{"Lines", 2, frame.bolts.size()};
  VtkFile file("PolyData", frame.time, counts_of(cells), coding);
  VtkRows arrays(file, frame.bolts, kBoltArrays, units);
  file.begin("CellData");
  arrays.add<std::int32_t>("bolt",
                           [](B b, std::size_t i) { return (b.number < 0 ? static_cast<int>(i) : b.number) + 1; });
  arrays.add<double>("force", [](B b, std::size_t) { return b.force; });
  arrays.add<std::int32_t>("is_broken", [](B b, std::size_t) { return b.is_broken; });
  file.end();
  std::vector<Point> places;
  for (B b : frame.bolts) places.insert(places.end(), {b.first, b.second});
  add_cells(file, cells, places);
  return std::move(file).text();
}

std::string cracks_vtp(const FieldFrame& field, const Units& units, VtkCoding coding) {
  struct Face {
    std::size_t crack;
    bool is_shear;
    const CrackFace* edge;
  };
  std::vector<Face> faces;
  for (std::size_t c = 0; c < field.cracks.size(); ++c)
    for (const CrackFace& edge : field.cracks[c].faces) faces.push_back({c, field.cracks[c].is_shear, &edge});
  using F = const Face&;
  const Cells cells{"Lines", 2, faces.size()};
  VtkFile file("PolyData", field.time, counts_of(cells), coding);
  VtkRows arrays(file, faces, kCrackArrays, units);
  file.begin("PointData");
  arrays.add_vectors<double>("displacement", [](F f) {
    return std::array{f.edge->ends[0].displacement, f.edge->ends[1].displacement};
  });
  file.end();
  file.begin("CellData");
  arrays.add<std::int32_t>("crack", [](F f, std::size_t) { return f.crack + 1; });
  arrays.add<std::int32_t>("side", [](F f, std::size_t) { return f.edge->is_left; });
  arrays.add<std::int32_t>("is_shear", [](F f, std::size_t) { return f.is_shear; });
  file.end();
  std::vector<Point> places;
  for (F f : faces)
    for (const FieldCorner& end : f.edge->ends) places.push_back(end.position + end.displacement);
  add_cells(file, cells, places);
  return std::move(file).text();
}

}  // namespace keyblock::formats
