// Reads LINE, LWPOLYLINE, POLYLINE, curves, POINT and INSERT; lists all others as skipped.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_entities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "base/sentences/sentences.hpp"
#include "formats/dxf/curves/dxf_curves.hpp"
#include "formats/dxf/entities/curve_entities.hpp"
#include "formats/dxf/entities/insertion.hpp"
#include "formats/dxf/entities/record_values.hpp"
#include "geometry/box.hpp"

namespace keyblock::formats {
namespace {

// Relative to the extent of a drawing, or to the height of its plane if greater. A smaller difference of heights is a
// rounding error of drawing programs.
constexpr double kLevel = 1e-9;

enum PolylineFlag { kClosed = 1, kMesh = 16, kPolyface = 64 };
constexpr int kSplineFrame = 16;  // of a VERTEX: a control point, not a point of the curve

class EntityReader {
 public:
  EntityReader(const DxfDocument& document, std::span<const DxfRecord> records, DxfDefinitions& definitions,
               const DxfVisibility& layers)
      : document_(document), of_(document), records_(records), definitions_(definitions), layers_(layers) {}

  DxfShapes read() {
    while (at_ < records_.size()) {
      const DxfRecord& record = records_[at_++];
      if (is_seen(record))
        read_record(record);
      else if (record.head.value == "POLYLINE")
        next_vertices(record);
    }
    return std::move(result_);
  }

 private:
  // Counts shapes on hidden layers. Layer 0 of a block is that of its INSERT.
  bool is_seen(const DxfRecord& record) {
    if (of_.is_in_paper_space(record)) {
      skip("entity in paper space", record);
      return false;
    }
    const std::string_view layer = DxfRecordValues::layer_of(record);
    const bool is_insert = record.head.value == "INSERT";
    const bool is_of_insert = definitions_.depth > 0 && layer == "0";
    if (!is_of_insert && record.head.value != "SEQEND" &&
        (is_insert ? layers_.is_frozen(layer) : layers_.is_hidden(layer))) {
      hide(layer, document_.place(record.head));
      return false;
    }
    if (!of_.is_invisible(record)) return true;
    skip(fmt::format("{} that is invisible", shown(record.head.value)), record);
    return false;
  }

  void hide(std::string_view layer, const Place& place) {
    result_.hidden.add(layer, place);
    result_.unread_layers.insert(layer);
  }

  void read_record(const DxfRecord& record) {
    const std::string_view type = record.head.value;
    if (type == "LINE") return read_line(record);
    if (type == "POINT") return read_point(record);
    if (type == "CIRCLE") return add_in_plane(circle_of(of_, record), of_.side_seen(record));
    if (type == "ARC") return add_in_plane(arc_of(of_, record), of_.side_seen(record));
    if (type == "ELLIPSE") return add_in_world(ellipse_of(document_, of_, record), record);
    if (type == "SPLINE") return read_spline(record);
    if (type == "LWPOLYLINE") return read_light_polyline(record);
    if (type == "POLYLINE") return read_polyline(record);
    if (DxfRecordValues::mark_of(record) != 0) return read_point(record);
    if (type == "INSERT") return read_insert(record);
    if (type == "SEQEND") return;  // of the attributes of an INSERT
    skip(shown(type), record);
  }

  static std::string shown(std::string_view type) {
    const bool is_plain = std::ranges::all_of(type, [](char c) { return c > ' ' && c <= 'Z'; });
    return is_plain && type.size() < 40 ? std::string(type) : in_quotes(type);
  }

  void skip(std::string_view kind, const DxfRecord& record) {
    result_.skipped.add(kind, document_.place(record.head));
    result_.unread_layers.insert(of_.layer_of(record));
  }

  /// Mirrors curves whose plane is seen from below, because its normal points down.
  void add_in_plane(DxfShape shape, int side) {
    if (side < 0) {
      for (Point& p : shape.points) p.x = -p.x;
      std::tie(shape.low, shape.high) = std::pair(-shape.high, -shape.low);
    }
    if (side == 0) shape.low = std::numeric_limits<double>::quiet_NaN();
    result_.shapes.push_back(std::move(shape));
  }

  /// Adds points in world coordinates, for either side of their plane.
  void add_in_world(DxfShape shape, const DxfRecord& record) {
    add_in_plane(std::move(shape), std::abs(of_.side_seen(record)));
  }

  static void count_chords(DxfShape& shape, std::size_t chords) {
    ++shape.curves;
    shape.chords += static_cast<std::uint32_t>(chords);
  }

  void read_line(const DxfRecord& record) {
    const Point start = of_.point(record, 10, "x of the start", "y of the start");
    DxfShape shape = of_.shape_of(record, {start, of_.point(record, 11, "x of the end", "y of the end")}, {30, 31});
    shape.bolt = of_.bolt_of(record);
    result_.shapes.push_back(std::move(shape));
  }

  void read_point(const DxfRecord& record) {
    DxfShape shape = of_.shape_of(record, {of_.point(record, 10, "x", "y")}, {30});
    shape.is_point = true;
    shape.mark = DxfRecordValues::mark_of(record);
    result_.shapes.push_back(std::move(shape));
  }

  void read_spline(const DxfRecord& record) {
    DxfShape shape = spline_of(document_, of_, record);
    if (shape.points.empty()) return skip("SPLINE whose knots, points or weights make no curve", record);
    add_in_world(std::move(shape), record);
  }

  void read_light_polyline(const DxfRecord& record) {
    std::vector<DxfCorner> corners = of_.light_corners(record);
    if (const DxfGroup* count = record.find(90)) {
      const int said = document_.integer(*count, "the number of vertices", record.head.value);
      if (said < 0 || static_cast<std::size_t>(said) != corners.size())
        result_.warnings.push_back(warning_of({"dxf_vertex_count", {{{"stated", said}, {"vertices", corners.size()}}}},
                                              document_.place(*count)));
    }
    DxfShape shape = of_.shape_of(record, {}, {38});
    shape.is_closed = (of_.flags(record) & kClosed) != 0;
    add_polyline(std::move(shape), corners, record);
  }

  /// Returns the records up to SEQEND, which is skipped.
  std::span<const DxfRecord> next_vertices(const DxfRecord& polyline) {
    const std::size_t first = at_;
    while (at_ < records_.size() && records_[at_].head.value == "VERTEX") ++at_;
    const std::size_t end = at_;
    if (end == records_.size())
      throw InputError(document_.place(polyline.head),
                       "expected VERTEX or SEQEND behind POLYLINE, found the end of the section");
    const DxfGroup& head = records_[end].head;
    if (head.value != "SEQEND")
      throw InputError(document_.place(head),
                       fmt::format("expected VERTEX or SEQEND of POLYLINE, found {}", in_quotes(head.value)));
    ++at_;
    return records_.subspan(first, end - first);
  }

  void read_polyline(const DxfRecord& record) {
    const std::span<const DxfRecord> vertices = next_vertices(record);
    const int kind = of_.flags(record);
    if ((kind & (kMesh | kPolyface)) != 0) return skip("POLYLINE that is a mesh", record);
    DxfShape shape = of_.shape_of(record, {}, {30});
    shape.is_closed = (kind & kClosed) != 0;
    std::vector<DxfCorner> corners;
    for (const DxfRecord& vertex : vertices) {
      if ((of_.flags(vertex) & kSplineFrame) != 0) continue;
      if (vertex.find(30) != nullptr) of_.add_heights(shape, vertex, {30});
      corners.push_back({of_.point(vertex, 10, "x", "y"), of_.real_or(0, vertex, 42, "the bulge"),
                         DxfRecordValues::layer_of(vertex)});
    }
    add_polyline(std::move(shape), corners, record);
  }

  /// Vertices that repeat the previous one begin no side.
  void add_polyline(DxfShape shape, const std::vector<DxfCorner>& corners, const DxfRecord& record) {
    const bool is_closed = shape.is_closed;
    shape.points.reserve(corners.size());
    shape.side_layers.reserve(corners.size());
    const std::size_t sides = is_closed ? corners.size() : corners.size() - std::min<std::size_t>(corners.size(), 1);
    for (std::size_t i = 0; i < sides; ++i) {
      const DxfCorner& corner = corners[i];
      const Point next = corners[i + 1 == corners.size() ? 0 : i + 1].position;
      if (corner.position == next) continue;
      const std::vector<Point> between = bulge_points(corner.position, next, corner.bulge);
      if (!between.empty()) count_chords(shape, between.size() + 1);
      shape.points.push_back(corner.position);
      shape.points.insert(shape.points.end(), between.begin(), between.end());
      shape.side_layers.resize(shape.points.size(), corner.layer);
    }
    if (shape.points.empty()) return skip(fmt::format("{} without a side", record.head.value), record);
    if (!is_closed) {
      shape.points.push_back(corners.back().position);
      shape.side_layers.push_back(corners.back().layer);
    }
    add_in_plane(std::move(shape), of_.side_seen(record));
  }

  const DxfShapes& shapes_of(DxfDefinition& definition, const DxfRecord& insert) {
    if (definition.shapes) return *definition.shapes;
    if (definition.is_open || definitions_.depth == DxfDefinitions::kDeepest)
      throw InputError(document_.place(insert.head),
                       fmt::format("expected INSERT of a block that holds itself not, nor others {} deep",
                                   DxfDefinitions::kDeepest));
    definition.is_open = true;
    ++definitions_.depth;
    definition.shapes =
        std::make_shared<const DxfShapes>(EntityReader(document_, definition.records, definitions_, layers_).read());
    --definitions_.depth;
    definition.is_open = false;
    result_.skipped.add_all(definition.shapes->skipped);
    result_.hidden.add_all(definition.shapes->hidden);
    result_.unread_layers.insert(definition.shapes->unread_layers.begin(), definition.shapes->unread_layers.end());
    result_.warnings = joined(std::move(result_.warnings), definition.shapes->warnings);
    return *definition.shapes;
  }

  /// Reads the shapes of a block, from its base point to the point of the INSERT. Shapes on layer 0 move to the layer
  /// of the INSERT; shapes without a colour get its colour.
  void read_insert(const DxfRecord& record) {
    const DxfGroup* name = record.find(2);
    if (name == nullptr)
      throw InputError(document_.place(record.head), "expected the name (group 2) of INSERT, found none");
    DxfDefinition* definition = definitions_.find(name->value);
    if (definition == nullptr) return skip("INSERT of a block that is not there", record);
    const int side = of_.side_seen(record);
    if (side == 0) return skip("INSERT in a tilted plane", record);
    const DxfInsertion made(of_, record, *definition);
    const std::vector<DxfShape>& shapes = shapes_of(*definition, record).shapes;
    if (shapes.empty()) return;
    const DxfShape own = of_.shape_of(record, {}, {});
    for (int row = 0; row < made.rows; ++row)
      for (int column = 0; column < made.columns; ++column)
        for (const DxfShape& shape : shapes) insert(shape, own, made, {column, row}, side);
  }

  void insert(DxfShape shape, const DxfShape& own, const DxfInsertion& made, std::pair<int, int> cell, int side) {
    definitions_.points += shape.points.size();
    if (definitions_.points > DxfDefinitions::kMostPoints)
      throw InputError(own.place, fmt::format("expected at most {} points of blocks drawn by INSERT, found more",
                                              DxfDefinitions::kMostPoints));
    if (shape.layer == "0" && layers_.is_hidden(own.layer)) return hide(own.layer, shape.place);
    for (Point& p : shape.points) p = made.placed(p, cell.first, cell.second);
    std::tie(shape.low, shape.high) =
        std::minmax({made.height + made.z * shape.low, made.height + made.z * shape.high});
    if (shape.layer == "0") shape.layer = own.layer;
    if (shape.colour == 0) shape.colour = own.colour;
    add_in_plane(std::move(shape), side);
  }

  const DxfDocument& document_;
  DxfRecordValues of_;
  std::span<const DxfRecord> records_;
  DxfDefinitions& definitions_;
  const DxfVisibility& layers_;
  std::size_t at_ = 0;
  DxfShapes result_;
};

/// Returns the height of the plane with most level shapes; if two have equally many, of the one nearer to 0.
double height_of_most(const std::vector<DxfShape>& shapes, double level) {
  std::vector<double> heights;
  for (const DxfShape& shape : shapes)
    if (shape.high - shape.low <= level) heights.push_back(shape.low);
  std::ranges::sort(heights);
  double best = 0;
  std::size_t most = 0;
  for (std::size_t first = 0, end = 0; first < heights.size(); first = end) {
    while (end < heights.size() && heights[end] - heights[first] <= level) ++end;
    const bool is_nearer = end - first == most && std::abs(heights[first]) < std::abs(best);
    if (end - first > most || is_nearer) best = heights[first];
    most = std::max(most, end - first);
  }
  return best;
}

}  // namespace

void keep_one_plane(DxfShapes& shapes) {
  const auto is_at_zero = [](const DxfShape& shape) { return shape.low == 0 && shape.high == 0; };
  if (std::ranges::all_of(shapes.shapes, is_at_zero)) return;
  Box box;
  double highest = 0;
  for (const DxfShape& shape : shapes.shapes) {
    for (const Point p : shape.points) box.add(p);
    if (std::isfinite(shape.low + shape.high)) highest = std::max({highest, std::abs(shape.low), std::abs(shape.high)});
  }
  const double level = kLevel * std::max(length(box.size()), highest);
  const double height = height_of_most(shapes.shapes, level);
  const auto is_outside = [&](const DxfShape& shape) {
    return !(std::abs(shape.low - height) <= level && std::abs(shape.high - height) <= level);
  };
  for (const DxfShape& shape : shapes.shapes) {
    if (!is_outside(shape)) continue;
    shapes.skipped.add(fmt::format("{} not in the plane z = {:g}", shape.type, height), shape.place);
    shapes.unread_layers.insert(shape.layer);
  }
  std::erase_if(shapes.shapes, is_outside);
}

DxfShapes read_entities(const DxfDocument& document, std::span<const DxfRecord> records, DxfDefinitions& definitions,
                        const DxfVisibility& layers) {
  return EntityReader(document, records, definitions, layers).read();
}

}  // namespace keyblock::formats
