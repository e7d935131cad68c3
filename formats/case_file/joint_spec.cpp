// Reads the specification of joint sets, key by key; layout in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/joint_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "formats/case_file/schema/joint_keys.hpp"
#include "formats/text/json_fields.hpp"
#include "geometry/box.hpp"
#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"

namespace keyblock::formats {
namespace {

constexpr double kRatio = 0.001;

/// Fields of an object of the specification, with the limits of its table.
class JointFields : public JsonFields {
 public:
  JointFields(const PlacedJson& object, std::string noun, std::string_view parent)
      : JsonFields(object, std::move(noun), joint_keys_of(parent)), parent_(parent) {}

  double real(std::string_view key, std::optional<double> absent = std::nullopt) const {
    return JsonFields::real(key, joint_demand(parent_, key), absent);
  }
  int integer(std::string_view key, std::optional<int> absent = std::nullopt) const {
    return JsonFields::integer(key, joint_demand(parent_, key), absent);
  }
  std::size_t word(std::string_view key, std::size_t absent) const {
    return JsonFields::word(key, joint_words_of(key), absent);
  }

 private:
  std::string_view parent_;
};

RectangleShape rectangle_of(const PlacedJson& value) {
  const JointFields fields(value, "the rectangle", "rectangle");
  RectangleShape shape;
  shape.width = fields.real("width");
  shape.height = fields.real("height");
  shape.x = fields.real("x", 0);
  shape.y = fields.real("y", 0);
  return shape;
}

/// Cutting merges corners nearer than the edge-node ratio times the extent: the face would be gone.
void require_lift(const SlopeShape& shape, const Place& place) {
  Box box;
  for (const Point corner : outline_of(shape)) box.add(corner);
  const double least = kRatio * std::max(box.size().x, box.size().y), lift = shape.height / shape.benches;
  if (lift <= least)
    throw InputError(place, fmt::format("expected a slope whose face rises by more than {:.3g} ({:g} of its extent), "
                                        "found {:.3g}",
                                        least, kRatio, lift));
}

SlopeShape slope_of(const PlacedJson& value) {
  const JointFields fields(value, "the slope", "slope");
  SlopeShape shape;
  shape.height = fields.real("height");
  shape.angle_deg = fields.real("angle");
  shape.bench = fields.real("bench", 0);
  shape.benches = fields.integer("benches", 1);
  shape.toe = fields.real("toe", shape.height);
  shape.crest = fields.real("crest", 1.5 * shape.height);
  shape.base = fields.real("base", shape.height / 2);
  shape.x = fields.real("x", 0);
  shape.y = fields.real("y", 0);
  require_lift(shape, value.place);
  return shape;
}

TunnelSection tunnel_of(const PlacedJson& value) {
  const JointFields fields(value, "a tunnel", "tunnel");
  if (!fields.has("shape"))
    throw InputError(value.place, "expected the shape of a tunnel (circle, d or horseshoe), found none");
  TunnelSection tunnel;
  tunnel.shape = static_cast<TunnelShape>(fields.word("shape", 0));
  tunnel.width = fields.real("width");
  tunnel.height = fields.real("height", tunnel.width);
  tunnel.x = fields.real("x");
  tunnel.y = fields.real("y");
  tunnel.place = value.place;
  return tunnel;
}

/// Reads the scatter and the distribution of a length, its own or those of the set.
class LengthReader {
 public:
  explicit LengthReader(const JointFields& fields)
      : fields_(fields),
        scatter_(fields.real("scatter", 0)),
        law_(fields.word("distribution", static_cast<std::size_t>(Distribution::lognormal))) {}

  double scatter() const { return scatter_; }

  RandomLength length(const std::string& key, std::optional<double> absent = std::nullopt) const {
    return {fields_.real(key, absent), fields_.real(key + "_scatter", scatter_),
            static_cast<Distribution>(fields_.word(key + "_distribution", law_))};
  }

 private:
  const JointFields& fields_;
  double scatter_;
  std::size_t law_;
};

/// Returns the scatter of the dip as a fraction of 90 degrees, also if a set has only `scatter`.
double dip_scatter_of(const JointFields& fields, double scatter) {
  if (!fields.has("dip_scatter_deg")) return fields.real("dip_scatter", scatter);
  if (fields.has("dip_scatter"))
    throw InputError(fields.place(), "expected one of dip_scatter_deg and dip_scatter, found both");
  return fields.real("dip_scatter_deg") / 90;
}

JointSet set_of(const PlacedJson& value, int number, int seed) {
  const JointFields fields(value, fmt::format("joint set {}", number), "set");
  const LengthReader reader(fields);
  JointSet set;
  set.dip_deg = fields.real("dip");
  set.dip_scatter = dip_scatter_of(fields, reader.scatter());
  set.spacing = reader.length("spacing");
  const RandomLength trace = reader.length("trace", 0);
  if (trace.mean > 0) set.trace_length = trace;
  set.gap = reader.length("gap", 0);
  if (!set.trace_length && set.gap.mean > 0)
    throw InputError(value.place, fmt::format("expected trace beside gap in joint set {}, found none", number));
  set.joint_material = fields.integer("joint", number) - 1;
  set.seed = static_cast<std::uint64_t>(fields.integer("seed", seed));
  set.stream = static_cast<std::uint64_t>(number);
  set.place = value.place;
  return set;
}

/// Returns a common point of two segments that meet.
Point meeting_point(const Segment& a, const Segment& b) {
  const Point along = a.end - a.start, across = b.end - b.start;
  if (meeting(a, b) == Meeting::crossing) return point_at(a, cross(b.start - a.start, across) / cross(along, across));
  const double share = foot(a, b.start);
  return share >= 0 && share <= 1 ? b.start : foot(b, a.start) >= 0 && foot(b, a.start) <= 1 ? a.start : a.end;
}

/// Throws InputError for two sides that meet apart from their common corner, at the first of them.
void require_simple(const Outline& corners, const PlacedJson& rows) {
  const std::size_t n = corners.size();
  const auto side_at = [&](std::size_t i) { return Segment{corners[i], corners[(i + 1) % n]}; };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n == i || meeting(side_at(i), side_at(j)) == Meeting::none) continue;
      const Point at = meeting_point(side_at(i), side_at(j));
      throw InputError(rows.items[i].place,
                       fmt::format("expected an outline whose sides do not cross, found sides {} and {} that meet at "
                                   "({:.6g}, {:.6g})",
                                   i + 1, j + 1, at.x, at.y));
    }
}

/// Returns the corners counter-clockwise.
Outline corners_of(const JointFields& fields) {
  Outline corners;
  for (const std::vector<double>& row : fields.rows("outline", 2)) corners.push_back({row[0], row[1]});
  const PlacedJson& rows = *fields.value("outline");
  if (corners.size() < 3)
    throw InputError(rows.place, fmt::format("expected an outline of three or more corners, found {}", corners.size()));
  require_simple(corners, rows);
  if (area(corners) == 0) throw InputError(rows.place, "expected an outline with an area, found none");
  if (area(corners) < 0) std::ranges::reverse(corners);
  return corners;
}

std::variant<RectangleShape, SlopeShape, Outline> outline_of_scene(const JointFields& fields) {
  const PlacedJson* rectangle = fields.value("rectangle");
  const PlacedJson* slope = fields.value("slope");
  const int count = (rectangle != nullptr) + (slope != nullptr) + (fields.value("outline") != nullptr);
  if (count != 1)
    throw InputError(fields.place(), fmt::format("expected one of rectangle, slope and outline, found {}",
                                                 count == 0 ? "none" : fmt::format("{}", count)));
  if (rectangle != nullptr) return rectangle_of(*rectangle);
  if (slope != nullptr) return slope_of(*slope);
  return corners_of(fields);
}

}  // namespace

JointScene joint_scene_of(const PlacedJson& specification) {
  const JointFields fields(specification, "the specification", "specification");
  JointScene scene;
  scene.place = {specification.place.file};
  scene.outline = outline_of_scene(fields);
  for (const PlacedJson& tunnel : fields.list("tunnels")) scene.tunnels.push_back(tunnel_of(tunnel));
  const int seed = fields.integer("seed", 1);
  int number = 0;
  for (const PlacedJson& set : fields.list("sets")) scene.sets.push_back(set_of(set, ++number, seed));
  scene.boundary_material = fields.integer("boundary_joint", 1) - 1;
  scene.edge_node_ratio = fields.real("edge_node_ratio", kRatio);
  for (const std::vector<double>& row : fields.rows("fixed", 4))
    scene.fixed_lines.push_back({{{row[0], row[1]}, {row[2], row[3]}}, fields.value("fixed")->place});
  for (const std::vector<double>& row : fields.rows("measured", 2))
    scene.measured_points.push_back({{row[0], row[1]}, fields.value("measured")->place});
  return scene;
}

}  // namespace keyblock::formats
