// Writes ASCII DXF R12: header, line types, layers with colours, entities.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "formats/dxf/dxf_units.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock::formats {
namespace {

constexpr int kColours = 6;  // 1 red, 2 yellow, 3 green, 4 cyan, 5 blue, 6 magenta; 7 is black or white
constexpr int kPlain = 7;

/// Collects entities and their layers.
class EntityWriter {
 public:
  void line(const std::string& layer, const Segment& segment, const std::string& extended_data = "") {
    head("LINE", layer);
    position(10, segment.start);
    position(11, segment.end);
    text_ += extended_data;
  }

  void point(const std::string& layer, Point at) {
    head("POINT", layer);
    position(10, at);
  }

  const std::string& text() const { return text_; }
  const std::map<std::string, int>& layers() const { return layers_; }

 private:
  void head(std::string_view type, const std::string& layer) {
    if (!layers_.contains(layer)) layers_.emplace(layer, colour_of(layer));
    text_ += fmt::format("0\n{}\n8\n{}\n", type, layer);
  }

  /// Numbered layers use the colours in turn, the others are plain.
  static int colour_of(std::string_view layer) {
    const std::size_t at = layer.rfind('_');
    if (at == std::string_view::npos || layer.starts_with("BOUNDARY")) return kPlain;
    const auto number = parse_real(layer.substr(at + 1)).value_or(1);
    return 1 + (static_cast<int>(number) % kColours + kColours + kColours - 1) % kColours;
  }

  void position(int code, Point p) {
    text_ += fmt::format("{}\n{}\n{}\n{}\n{}\n0\n", code, format_real(p.x), code + 10, format_real(p.y), code + 20);
  }

  std::string text_;
  std::map<std::string, int> layers_;
};

std::string extended_data(double stiffness, double strength, double pretension) {
  if (stiffness == 0 && strength == 0 && pretension == 0) return "";
  return fmt::format("1001\nKEYBLOCK\n1040\n{}\n1040\n{}\n1040\n{}\n", format_real(stiffness), format_real(strength),
                     format_real(pretension));
}

std::string numbered(std::string_view word, int index) {
  return fmt::format("{}_{}", word, index + 1);
}

void add(EntityWriter& writer, const Drawing& drawing) {
  for (std::size_t i = 0; i < drawing.joints.size(); ++i) {
    const JointLine& line = drawing.joints[i];
    writer.line(numbered(i < drawing.boundary_count ? "BOUNDARY" : "JOINT", line.joint_material), line.segment);
  }
  for (const MaterialLine& line : drawing.material_lines)
    writer.line(numbered("MATERIAL", line.block_material), line.segment);
  for (const BoltLine& bolt : drawing.bolts)
    writer.line(numbered("BOLT", bolt.type), bolt.segment,
                extended_data(bolt.stiffness, bolt.strength, bolt.pretension));
  for (const FixedLine& line : drawing.fixed_lines) {
    if (line.segment.start == line.segment.end)
      writer.point("FIXED", line.segment.start);
    else
      writer.line("FIXED", line.segment);
  }
  for (const MarkedPoint& point : drawing.loading_points) writer.point("LOAD", point.position);
  for (const MarkedPoint& point : drawing.measured_points) writer.point("MEASURED", point.position);
  for (const MarkedPoint& point : drawing.hole_points) writer.point("HOLE", point.position);
}

std::string table(std::string_view name, std::size_t count, const std::string& entries) {
  return fmt::format("0\nTABLE\n2\n{}\n70\n{}\n{}0\nENDTAB\n", name, count, entries);
}

std::string section(std::string_view name, const std::string& inside) {
  return fmt::format("0\nSECTION\n2\n{}\n{}0\nENDSEC\n", name, inside);
}

std::string tables(const std::map<std::string, int>& layers) {
  std::string entries;
  for (const auto& [name, colour] : layers)
    entries += fmt::format("0\nLAYER\n2\n{}\n70\n0\n62\n{}\n6\nCONTINUOUS\n", name, colour);
  return table("LTYPE", 1, "0\nLTYPE\n2\nCONTINUOUS\n70\n0\n3\nSolid line\n72\n65\n73\n0\n40\n0\n") +
         table("LAYER", layers.size(), entries) + table("APPID", 1, "0\nAPPID\n2\nKEYBLOCK\n70\n0\n");
}

}  // namespace

std::string write_dxf(const Content& content) {
  if (!content.drawing) throw std::invalid_argument("a DXF file needs a drawing");
  EntityWriter writer;
  add(writer, *content.drawing);
  std::string text = fmt::format("999\n{}{}\n", kDxfRatioComment, format_real(content.drawing->edge_node_ratio));
  const std::string length = content.units ? content.units->length : "";
  text += section("HEADER", fmt::format("9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n{}\n", dxf_unit_number(length)));
  text += section("TABLES", tables(writer.layers()));
  text += section("ENTITIES", writer.text());
  return text + "0\nEOF\n";
}

}  // namespace keyblock::formats
