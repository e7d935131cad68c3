// Reads the lists of a DDAML geometry; the elements are in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/ddaml_geometry.hpp"

#include <fmt/format.h>

#include <array>

#include "formats/berkeley/ddaml_ignored.hpp"
#include "formats/text/decimal_comma.hpp"
#include "formats/text/demands.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {
namespace {

class GeometryReader {
 public:
  GeometryReading read(const Element& geometry) {
    for (const Element& list : geometry.children()) read_list(list);
    if (!edge_node_seen_)
      throw InputError(geometry.place(), "expected an Edgenodedist element in Geometry, found none");
    place_boundaries_first();
    result_.drawing.place = {geometry.place().file};
    return std::move(result_);
  }

 private:
  struct List {
    std::string_view name;
    void (GeometryReader::*read_item)(const Element& item, const Record& record);
  };
  static const std::array<List, 8> kLists;

  void read_list(const Element& element) {
    if (element.name() == "Edgenodedist") return read_edge_node_ratio(element);
    for (const List& list : kLists)
      if (list.name == element.name()) return read_items(element, list);
    add_warning(result_.warnings, ignored(element));
  }

  void read_edge_node_ratio(const Element& element) {
    const Tokens tokens = element.attribute_tokens("distance");
    Cursor cursor(tokens, "nothing");
    result_.drawing.edge_node_ratio = cursor.next_real("the edge-node ratio", kEdgeNodeRatio);
    keep_remainder(tokens, cursor);
    if (edge_node_seen_) add_warning(result_.warnings, repeated(element));
    edge_node_seen_ = true;
  }

  void read_items(const Element& element, const List& list) {
    const std::vector<Element> items = element.children();
    for (std::size_t i = 0; i < items.size(); ++i)
      (this->*list.read_item)(items[i], {items[i].name(), i + 1, items.size()});
  }

  bool is_named(const Element& item, std::string_view name) {
    if (item.name() == name) return true;
    add_warning(result_.warnings, ignored(item));
    return false;
  }

  void keep_remainder(const Tokens& tokens, const Cursor& cursor) {
    if (cursor.numbers_left() > 0)
      refuse_decimal_commas(*tokens.map, tokens.text, tokens.start_of(0), tokens.end - tokens.start_of(0));
    for (Warning& warning : cursor.remainder()) add_warning(result_.warnings, std::move(warning));
  }

  static Point next_point(Cursor& cursor, std::string_view x_name, std::string_view y_name) {
    const double x = cursor.next_real(x_name);
    return {x, cursor.next_real(y_name)};
  }

  static Segment next_segment(Cursor& cursor) {
    const Point start = next_point(cursor, "x of the start", "y of the start");
    return {start, next_point(cursor, "x of the end", "y of the end")};
  }

  Segment segment_of(const Element& item, const Record& record) {
    const Tokens tokens = item.tokens();
    Cursor cursor(tokens, kEndOfElement);
    cursor.enter(record);
    const Segment segment = next_segment(cursor);
    keep_remainder(tokens, cursor);
    return segment;
  }

  MarkedPoint point_of(const Element& item, const Record& record) {
    const Tokens tokens = item.tokens();
    Cursor cursor(tokens, kEndOfElement);
    cursor.enter(record);
    const Point point = next_point(cursor, "x", "y");
    keep_remainder(tokens, cursor);
    return {point, item.place()};
  }

  int type_of(const Element& item, std::string_view meaning, const Record& record) {
    const Tokens tokens = item.attribute_tokens("type");
    Cursor cursor(tokens, "nothing");
    cursor.enter(record);
    const int type = cursor.next_index(meaning);
    keep_remainder(tokens, cursor);
    return type;
  }

  void read_joint(const Element& item, const Record& record) {
    if (!is_named(item, "Joint")) return;
    const int material = type_of(item, "the joint material (attribute type)", record);
    result_.drawing.joints.push_back({segment_of(item, record), material, item.place()});
  }

  void read_boundary(const Element& item, const Record& record) {
    if (!is_named(item, "Line")) return;
    const int material = item.attribute("type") ? type_of(item, "the joint material (attribute type)", record) : 0;
    boundaries_.push_back({segment_of(item, record), material, item.place()});
  }

  void read_fixed(const Element& item, const Record& record) {
    if (item.name() == "Point") {
      const MarkedPoint point = point_of(item, record);
      result_.drawing.fixed_lines.push_back({{point.position, point.position}, point.place});
    } else if (is_named(item, "Line")) {
      result_.drawing.fixed_lines.push_back({segment_of(item, record), item.place()});
    }
  }

  void read_loading(const Element& item, const Record& record) {
    if (is_named(item, "Point")) result_.drawing.loading_points.push_back(point_of(item, record));
  }

  void read_measured(const Element& item, const Record& record) {
    if (is_named(item, "Point")) result_.drawing.measured_points.push_back(point_of(item, record));
  }

  void read_hole(const Element& item, const Record& record) {
    if (is_named(item, "Point")) result_.drawing.hole_points.push_back(point_of(item, record));
  }

  void read_bolt(const Element& item, const Record& record) {
    if (!is_named(item, "Bolt")) return;
    BoltLine bolt;
    bolt.type = item.attribute("type") ? type_of(item, "the bolt type (attribute type)", record) : 0;
    bolt.segment = segment_of(item, record);
    bolt.place = item.place();
    result_.drawing.bolts.push_back(bolt);
  }

  void read_material_line(const Element& item, const Record& record) {
    if (!is_named(item, "Line")) return;
    const Tokens tokens = item.tokens();
    Cursor cursor(tokens, kEndOfElement);
    cursor.enter(record);
    const Segment segment = next_segment(cursor);
    const bool material_is_fifth_number = !item.attribute("type") && cursor.numbers_left() > 0;
    const int material = material_is_fifth_number ? cursor.next_index("the block material")
                                                  : type_of(item, "the block material (attribute type)", record);
    keep_remainder(tokens, cursor);
    result_.drawing.material_lines.push_back({segment, material, item.place()});
  }

  void place_boundaries_first() {
    std::vector<JointLine>& joints = result_.drawing.joints;
    joints.insert(joints.begin(), boundaries_.begin(), boundaries_.end());
    result_.drawing.boundary_count = boundaries_.size();
  }

  GeometryReading result_;
  std::vector<JointLine> boundaries_;
  bool edge_node_seen_ = false;
};

const std::array<GeometryReader::List, 8> GeometryReader::kLists{{
    {"Jointlist", &GeometryReader::read_joint},
    {"Boundlist", &GeometryReader::read_boundary},
    {"Fixedpointlist", &GeometryReader::read_fixed},
    {"Loadpointlist", &GeometryReader::read_loading},
    {"Measuredpointlist", &GeometryReader::read_measured},
    {"Holepointlist", &GeometryReader::read_hole},
    {"Boltlist", &GeometryReader::read_bolt},
    {"Matlinelist", &GeometryReader::read_material_line},
}};

}  // namespace

GeometryReading read_geometry(const Element& geometry) {
  return GeometryReader{}.read(geometry);
}

}  // namespace keyblock::formats
