// Writes VTK's PolyData by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtk_parts.hpp"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "formats/tables/run_tables.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock::formats {
namespace {

std::string real(double value) {
  return fmt::format("{:.12g}", value);
}

std::string vector_line(Point p) {
  return fmt::format("{:.12g} {:.12g} 0", p.x, p.y);
}

/// One value a row of `rows`, or three with `width` 3.
template <class Rows, class Value>
void append_array(std::string& text, const Rows& rows, std::string_view type, std::string_view name, int width,
                  Value value) {
  text += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type, name,
                      width);
  for (const auto& row : rows) text += value(row) + "\n";
  text += "</DataArray>\n";
}

// `cells`: of the word Verts or Lines, of `size` points each, in their order.
std::string opening(double time, std::string_view word, std::size_t cells, std::size_t size) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<PolyData>\n<FieldData>\n"
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n"
      "</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOf{}=\"{}\">\n",
      format_real(time), cells * size, word, cells);
}

std::string cells_of(std::string_view word, std::size_t cells, std::size_t size) {
  std::string text = fmt::format("<{}>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n", word);
  for (std::size_t i = 0; i < cells * size; ++i) text += fmt::format("{}\n", i);
  text += "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for (std::size_t i = 1; i <= cells; ++i) text += fmt::format("{}\n", i * size);
  return text + fmt::format("</DataArray>\n</{}>\n", word);
}

constexpr std::string_view kPointsOpening =
    "<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n";
constexpr std::string_view kPointsEnd = "</DataArray>\n</Points>\n";
constexpr std::string_view kEnd = "</Piece>\n</PolyData>\n</VTKFile>\n";

}  // namespace

std::string contacts_vtp(double time, const ContactFrames& contacts, const Units& units) {
  using C = const ContactFrame&;
  const auto number = [](int index) { return fmt::format("{}", index + 1); };
  std::string text = opening(time, "Verts", contacts.size(), 1);
  text += "<PointData>\n";
  append_array(text, contacts, "Int32", heading(kContactArrays, "block", units), 1,
               [&](C c) { return number(c.element); });
  append_array(text, contacts, "Int32", heading(kContactArrays, "other", units), 1,
               [&](C c) { return number(c.other); });
  append_array(text, contacts, "Int32", heading(kContactArrays, "joint_material", units), 1,
               [&](C c) { return number(c.joint_material); });
  append_array(text, contacts, "Int32", heading(kContactArrays, "joint", units), 1,
               [&](C c) { return number(c.joint_line); });
  append_array(text, contacts, "Int32", heading(kContactArrays, "state", units), 1,
               [](C c) { return fmt::format("{}", static_cast<int>(c.condition)); });
  append_array(text, contacts, "Float64", heading(kContactArrays, "gap", units), 1, [](C c) { return real(c.gap); });
  append_array(text, contacts, "Float64", heading(kContactArrays, "slip", units), 1, [](C c) { return real(c.slip); });
  append_array(text, contacts, "Float64", heading(kContactArrays, "normal_force", units), 1,
               [](C c) { return real(c.normal_force); });
  append_array(text, contacts, "Float64", heading(kContactArrays, "shear_force", units), 1,
               [](C c) { return real(c.shear_force); });
  append_array(text, contacts, "Float64", heading(kContactArrays, "normal", units), 3,
               [](C c) { return vector_line(c.normal); });
  append_array(text, contacts, "Float64", heading(kContactArrays, "force", units), 3,
               [](C c) { return vector_line(c.force()); });
  text += "</PointData>\n";
  text += kPointsOpening;
  for (C c : contacts) text += vector_line(c.position) + "\n";
  text += kPointsEnd;
  return text + cells_of("Verts", contacts.size(), 1) + std::string(kEnd);
}

std::string bolts_vtp(const Frame& frame, const Units& units) {
  using B = const BoltFrame&;
  std::string text = opening(frame.time, "Lines", frame.bolts.size(), 2);
  std::size_t next = 0;
  text += "<CellData>\n";
  append_array(text, frame.bolts, "Int32", heading(kBoltArrays, "bolt", units), 1, [&](B b) {
    const std::size_t index = next++;
    return fmt::format("{}", (b.number < 0 ? static_cast<int>(index) : b.number) + 1);
  });
  append_array(text, frame.bolts, "Float64", heading(kBoltArrays, "force", units), 1,
               [](B b) { return real(b.force); });
  append_array(text, frame.bolts, "Int32", heading(kBoltArrays, "is_broken", units), 1,
               [](B b) { return fmt::format("{:d}", b.is_broken); });
  text += "</CellData>\n";
  text += kPointsOpening;
  for (B b : frame.bolts) text += vector_line(b.first) + "\n" + vector_line(b.second) + "\n";
  text += kPointsEnd;
  return text + cells_of("Lines", frame.bolts.size(), 2) + std::string(kEnd);
}

std::string cracks_vtp(const FieldFrame& field, const Units& units) {
  struct Face {
    std::size_t crack;
    bool is_shear;
    const CrackFace* edge;
  };
  std::vector<Face> faces;
  for (std::size_t c = 0; c < field.cracks.size(); ++c)
    for (const CrackFace& edge : field.cracks[c].faces) faces.push_back({c, field.cracks[c].is_shear, &edge});
  using F = const Face&;
  std::string text = opening(field.time, "Lines", faces.size(), 2);
  text += "<PointData>\n";
  append_array(text, faces, "Float64", heading(kCrackArrays, "displacement", units), 3, [](F f) {
    return vector_line(f.edge->ends[0].displacement) + "\n" + vector_line(f.edge->ends[1].displacement);
  });
  text += "</PointData>\n<CellData>\n";
  append_array(text, faces, "Int32", heading(kCrackArrays, "crack", units), 1,
               [](F f) { return fmt::format("{}", f.crack + 1); });
  append_array(text, faces, "Int32", heading(kCrackArrays, "side", units), 1,
               [](F f) { return fmt::format("{:d}", f.edge->is_left); });
  append_array(text, faces, "Int32", heading(kCrackArrays, "is_shear", units), 1,
               [](F f) { return fmt::format("{:d}", f.is_shear); });
  text += "</CellData>\n";
  text += kPointsOpening;
  for (F f : faces)
    for (const FieldCorner& end : f.edge->ends) text += vector_line(end.position + end.displacement) + "\n";
  text += kPointsEnd;
  return text + cells_of("Lines", faces.size(), 2) + std::string(kEnd);
}

}  // namespace keyblock::formats
