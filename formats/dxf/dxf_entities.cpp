// Reads LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE, POINT and INSERT; all else is listed as skipped.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_entities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "formats/dxf/dxf_curves.hpp"

namespace keyblock::formats {
namespace {

constexpr double kFlat = 1e-9;  // heights and tilts below this are the rounding of drawing programs
constexpr std::string_view kApplication = "KEYBLOCK";

enum PolylineFlag { kClosed = 1, kMesh = 16, kPolyface = 64 };
constexpr int kSplineFrame = 16;  // of a VERTEX: it steers the curve and is none of its points

/// A corner of a polyline and the bulge of the side that begins there.
struct Corner {
  Point position;
  double bulge = 0;
  std::string_view layer;
};

/// What groups of a record say, each with the complaint about one that does not.
class RecordValues {
 public:
  explicit RecordValues(const DxfDocument& document) : document_(document) {}

  double real(const DxfRecord& record, int code, std::string_view name) const {
    const DxfGroup* group = record.find(code);
    if (group == nullptr)
      throw InputError(document_.place(record.head),
                       fmt::format("expected {} (group {}) of {}, found none", name, code, record.head.value));
    return document_.real(*group, name, record.head.value);
  }

  double real_or_zero(const DxfRecord& record, int code, std::string_view name) const {
    return record.find(code) == nullptr ? 0 : real(record, code, name);
  }

  int flags(const DxfRecord& record) const {
    const DxfGroup* group = record.find(70);
    return group == nullptr ? 0 : document_.integer(*group, "the flags", record.head.value);
  }

  bool is_in_paper_space(const DxfRecord& record) const {
    const DxfGroup* group = record.find(67);
    return group != nullptr && document_.integer(*group, "the space", record.head.value) == 1;
  }

  static std::string_view layer_of(const DxfRecord& record) {
    const DxfGroup* group = record.find(8);
    return group == nullptr ? std::string_view("0") : group->value;
  }

  Point point(const DxfRecord& record, int code, std::string_view x, std::string_view y) const {
    const double first = real(record, code, x);
    return {first, real(record, code + 10, y)};
  }

  /// The z component of the plane's normal: 1, or -1 where x is mirrored; nothing where the entity does not lie in
  /// z = 0.
  std::optional<int> side_seen(const DxfRecord& record, std::initializer_list<int> heights) const {
    for (const int code : heights)
      if (std::abs(real_or_zero(record, code, "z")) > kFlat) return std::nullopt;
    if (record.find(230) == nullptr) return 1;
    const double x = real_or_zero(record, 210, "x of the normal");
    const double y = real_or_zero(record, 220, "y of the normal");
    if (std::abs(x) > kFlat || std::abs(y) > kFlat) return std::nullopt;
    return real(record, 230, "z of the normal") < 0 ? -1 : 1;
  }

  /// Ends of lines and points are said in world coordinates, whatever the normal.
  bool is_flat(const DxfRecord& record, std::initializer_list<int> heights) const {
    return std::ranges::all_of(heights, [&](int code) { return std::abs(real_or_zero(record, code, "z")) <= kFlat; });
  }

  DxfShape shape_of(const DxfRecord& record, std::vector<Point> points) const {
    DxfShape shape{
        record.head.value, layer_of(record), document_.place(record.head), false, false, std::move(points), {}, {}};
    if (const DxfGroup* group = record.find(62)) shape.colour = document_.integer(*group, "the colour", shape.type);
    return shape;
  }

  /// The letter of a text that is one of the marks of the old Windows program; 0 for every other entity.
  static char mark_of(const DxfRecord& record) {
    constexpr std::string_view kMarks = "FLMH";
    const bool is_text = record.head.value == "MTEXT" || record.head.value == "TEXT";
    const DxfGroup* text = is_text ? record.find(1) : nullptr;
    const bool is_mark =
        text != nullptr && text->value.size() == 1 && kMarks.find(text->value.front()) != std::string_view::npos;
    return is_mark ? text->value.front() : '\0';
  }

  double radius(const DxfRecord& record) const {
    const double value = real(record, 40, "the radius");
    if (value > 0) return value;
    throw InputError(document_.place(*record.find(40)),
                     fmt::format("expected the radius (group 40, greater than 0) of {}, found {}", record.head.value,
                                 in_quotes(record.find(40)->value)));
  }

  double scale_of(const DxfRecord& record, int code, std::string_view name) const {
    return record.find(code) == nullptr ? 1 : real(record, code, name);
  }

  /// Group 10 opens a corner; 20 and 42 belong to the corner before them.
  std::vector<Corner> light_corners(const DxfRecord& record) const {
    std::vector<Corner> corners;
    corners.reserve(static_cast<std::size_t>(std::ranges::count(record.groups, 10, &DxfGroup::code)));
    bool y_is_missing = false;
    const auto complain = [&] {
      throw InputError(document_.place(record.head),
                       fmt::format("expected y (group 20) of vertex {} of LWPOLYLINE, found none", corners.size()));
    };
    for (const DxfGroup& group : record.groups) {
      if (group.code >= 1000) break;
      if (group.code == 10) {
        if (y_is_missing) complain();
        corners.push_back({{document_.real(group, "x of a vertex", "LWPOLYLINE"), 0}, 0, {}});
        y_is_missing = true;
      } else if (group.code == 20 && y_is_missing) {
        corners.back().position.y = document_.real(group, "y of a vertex", "LWPOLYLINE");
        y_is_missing = false;
      } else if (group.code == 42 && !corners.empty()) {
        corners.back().bulge = document_.real(group, "the bulge", "LWPOLYLINE");
      }
    }
    if (y_is_missing) complain();
    return corners;
  }

  std::optional<std::array<double, 3>> bolt_of(const DxfRecord& record) const {
    std::vector<double> values;
    const DxfGroup* application = nullptr;
    bool is_ours = false;
    for (const DxfGroup& group : record.groups) {
      if (group.code == 1001) is_ours = group.value == kApplication;
      if (group.code == 1001 && is_ours) application = &group;
      if (group.code == 1040 && is_ours) values.push_back(document_.real(group, "a value", "the bolt"));
    }
    if (application == nullptr) return std::nullopt;
    if (values.size() == 3) return std::array<double, 3>{values[0], values[1], values[2]};
    throw InputError(
        document_.place(*application),
        fmt::format("expected 3 values (group 1040) of the bolt: stiffness, strength, pre-tension, found {}",
                    values.size()));
  }

 private:
  const DxfDocument& document_;
};

class EntityReader {
 public:
  EntityReader(const DxfDocument& document, std::span<const DxfRecord> records, DxfDefinitions& definitions)
      : document_(document), of_(document), records_(records), definitions_(definitions) {}

  DxfShapes read() {
    while (at_ < records_.size()) {
      const DxfRecord& record = records_[at_++];
      if (of_.is_in_paper_space(record)) {
        skip("entity in paper space", record);
        if (record.head.value == "POLYLINE") next_vertices(record);
      } else {
        read_record(record);
      }
    }
    return std::move(result_);
  }

 private:
  void read_record(const DxfRecord& record) {
    const std::string_view type = record.head.value;
    if (type == "LINE") return read_line(record);
    if (type == "POINT") return read_point(record);
    if (type == "CIRCLE") return read_circle(record);
    if (type == "ARC") return read_arc(record);
    if (type == "LWPOLYLINE") return read_light_polyline(record);
    if (type == "POLYLINE") return read_polyline(record);
    if (RecordValues::mark_of(record) != 0) return read_mark(record);
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

  void skip_solid(const DxfRecord& record) {
    skip(fmt::format("{} not in the plane z = 0", record.head.value), record);
  }

  /// Curves lie in a plane of their own, seen from below where its normal points down.
  void add_in_plane(DxfShape shape, int side) {
    if (side < 0)
      for (Point& p : shape.points) p.x = -p.x;
    result_.shapes.push_back(std::move(shape));
  }

  static void count_chords(DxfShape& shape, std::size_t chords) {
    ++shape.curves;
    shape.chords += static_cast<std::uint32_t>(chords);
  }

  void read_line(const DxfRecord& record) {
    if (!of_.is_flat(record, {30, 31})) return skip_solid(record);
    const Point start = of_.point(record, 10, "x of the start", "y of the start");
    DxfShape shape = of_.shape_of(record, {start, of_.point(record, 11, "x of the end", "y of the end")});
    shape.bolt = of_.bolt_of(record);
    result_.shapes.push_back(std::move(shape));
  }

  void read_point(const DxfRecord& record) {
    if (!of_.is_flat(record, {30})) return skip_solid(record);
    DxfShape shape = of_.shape_of(record, {of_.point(record, 10, "x", "y")});
    shape.is_point = true;
    result_.shapes.push_back(std::move(shape));
  }

  void read_mark(const DxfRecord& record) {
    if (!of_.is_flat(record, {30})) return skip_solid(record);
    DxfShape shape = of_.shape_of(record, {of_.point(record, 10, "x", "y")});
    shape.is_point = true;
    shape.mark = RecordValues::mark_of(record);
    result_.shapes.push_back(std::move(shape));
  }

  void read_circle(const DxfRecord& record) {
    const auto side = of_.side_seen(record, {30});
    if (!side) return skip_solid(record);
    const Point centre = of_.point(record, 10, "x of the centre", "y of the centre");
    DxfShape shape = of_.shape_of(record, arc_points(centre, of_.radius(record), 0, 2 * std::numbers::pi));
    shape.points.pop_back();
    shape.is_closed = true;
    count_chords(shape, shape.points.size());
    add_in_plane(std::move(shape), *side);
  }

  void read_arc(const DxfRecord& record) {
    const auto side = of_.side_seen(record, {30});
    if (!side) return skip_solid(record);
    const Point centre = of_.point(record, 10, "x of the centre", "y of the centre");
    const double start = of_.real(record, 50, "the start angle");
    const double turn = std::fmod(of_.real(record, 51, "the end angle") - start, 360);
    const double sweep = turn > 0 ? turn : turn + 360;
    const double degree = std::numbers::pi / 180;
    DxfShape shape =
        of_.shape_of(record, arc_points(centre, of_.radius(record), degree * std::fmod(start, 360), degree * sweep));
    count_chords(shape, shape.points.size() - 1);
    add_in_plane(std::move(shape), *side);
  }

  void read_light_polyline(const DxfRecord& record) {
    std::vector<Corner> corners = of_.light_corners(record);
    if (const DxfGroup* count = record.find(90)) {
      const int said = document_.integer(*count, "the number of vertices", record.head.value);
      if (said < 0 || static_cast<std::size_t>(said) != corners.size())
        result_.warnings.push_back(
            {"dxf_vertex_count", document_.place(*count),
             fmt::format("group 90 says {} vertices, the LWPOLYLINE has {}; these are read", said, corners.size())});
    }
    const auto side = of_.side_seen(record, {38});
    if (!side) return skip_solid(record);
    add_polyline(record, corners, (of_.flags(record) & kClosed) != 0, *side);
  }

  /// The records up to SEQEND, which is passed.
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
    const auto side = of_.side_seen(record, {30});
    std::vector<Corner> corners;
    bool is_flat_all = side.has_value();
    for (const DxfRecord& vertex : vertices) {
      if ((of_.flags(vertex) & kSplineFrame) != 0) continue;
      is_flat_all = is_flat_all && of_.is_flat(vertex, {30});
      corners.push_back(
          {of_.point(vertex, 10, "x", "y"), of_.real_or_zero(vertex, 42, "the bulge"), RecordValues::layer_of(vertex)});
    }
    if (!is_flat_all) return skip_solid(record);
    add_polyline(record, corners, (kind & kClosed) != 0, *side);
  }

  /// Vertices that repeat the one before them begin no side.
  void add_polyline(const DxfRecord& record, const std::vector<Corner>& corners, bool is_closed, int side) {
    DxfShape shape = of_.shape_of(record, {});
    shape.is_closed = is_closed;
    shape.points.reserve(corners.size());
    shape.side_layers.reserve(corners.size());
    const std::size_t sides = is_closed ? corners.size() : corners.size() - std::min<std::size_t>(corners.size(), 1);
    for (std::size_t i = 0; i < sides; ++i) {
      const Corner& corner = corners[i];
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
    add_in_plane(std::move(shape), side);
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
        std::make_shared<const DxfShapes>(EntityReader(document_, definition.records, definitions_).read());
    --definitions_.depth;
    definition.is_open = false;
    result_.skipped.add_all(definition.shapes->skipped);
    result_.unread_layers.insert(definition.shapes->unread_layers.begin(), definition.shapes->unread_layers.end());
    result_.warnings = joined(std::move(result_.warnings), definition.shapes->warnings);
    return *definition.shapes;
  }

  /// The shapes of a block, from its base point to the point of the INSERT, scaled, then turned. What lies on layer 0
  /// comes to the layer of the INSERT, what has no colour gets its colour.
  void read_insert(const DxfRecord& record) {
    const DxfGroup* name = record.find(2);
    if (name == nullptr)
      throw InputError(document_.place(record.head), "expected the name (group 2) of INSERT, found none");
    DxfDefinition* definition = definitions_.find(name->value);
    if (definition == nullptr) return skip("INSERT of a block that is not there", record);
    const auto is_many = [&](int code) {
      return record.find(code) != nullptr && document_.integer(*record.find(code), "the count", "INSERT") > 1;
    };
    if (is_many(70) || is_many(71)) return skip("INSERT in rows or columns", record);
    const auto side = of_.side_seen(record, {30});
    if (!side) return skip_solid(record);
    const Point at = of_.point(record, 10, "x", "y");
    const double x = of_.scale_of(record, 41, "the scale in x"), y = of_.scale_of(record, 42, "the scale in y");
    const double angle = std::numbers::pi / 180 * std::fmod(of_.real_or_zero(record, 50, "the angle"), 360);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const std::string_view layer = RecordValues::layer_of(record);
    const int colour = of_.shape_of(record, {}).colour;
    for (DxfShape shape : shapes_of(*definition, record).shapes) {
      definitions_.points += shape.points.size();
      if (definitions_.points > DxfDefinitions::kMostPoints)
        throw InputError(document_.place(record.head), fmt::format("expected at most {} points of blocks drawn by "
                                                                   "INSERT, found more",
                                                                   DxfDefinitions::kMostPoints));
      for (Point& p : shape.points) {
        const Point scaled{x * (p.x - definition->base.x), y * (p.y - definition->base.y)};
        p = at + Point{cosine * scaled.x - sine * scaled.y, sine * scaled.x + cosine * scaled.y};
      }
      if (shape.layer == "0") shape.layer = layer;
      if (shape.colour == 0) shape.colour = colour;
      add_in_plane(std::move(shape), *side);
    }
  }

  const DxfDocument& document_;
  RecordValues of_;
  std::span<const DxfRecord> records_;
  DxfDefinitions& definitions_;
  std::size_t at_ = 0;
  DxfShapes result_;
};

}  // namespace

DxfShapes read_entities(const DxfDocument& document, std::span<const DxfRecord> records, DxfDefinitions& definitions) {
  return EntityReader(document, records, definitions).read();
}

}  // namespace keyblock::formats
