// Fills the columns part by part.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/columns/frame_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

#include "formats/columns/column_filler.hpp"
#include "formats/columns/contact_columns.hpp"

namespace keyblock::formats {
namespace {

Components components(const Stress& s) {
  return {s.xx, s.yy, s.xy, s.zz};
}

Components components(const PlasticState& s) {
  return {s.xx, s.yy, s.xy, s.zz};
}

PlasticState plastic_of(const ElementFrame& element) {
  return element.plastic.value_or(PlasticState{});
}
PlasticState plastic_of(const FieldCorner* corner) {
  return corner->plastic.value_or(PlasticState{});
}

template <class Row>
void add_plastic(const ColumnFiller<Row>& fill) {
  fill.tensor("plastic_strain", [](const Row& r) { return components(plastic_of(r)); });
  fill.real("equivalent_plastic_strain", [](const Row& r) { return plastic_of(r).equivalent; });
}

/// Returns the number of fixed points of each block, by its number.
std::unordered_map<int, int> fixed_points_by_block(const Frame& frame) {
  std::unordered_map<int, int> counts;
  for (const PointFrame& point : frame.fixed_points) ++counts[point.element];
  return counts;
}

FramePart blocks_of(const Frame& frame, const FieldFrame& field) {
  using E = const ElementFrame&;
  FramePart part{"blocks", frame.elements.size(), {}};
  const ColumnFiller fill(part, frame.elements);
  const auto fixed = fixed_points_by_block(frame);
  fill.integer("block", [&](E, std::size_t i) { return number_of(frame, i) + 1; });
  // Written only if parts were cut off: otherwise the numbers are those of the blocks.
  if (std::ranges::any_of(frame.elements, [](E e) { return e.origin >= 0 && e.origin != e.number; }))
    fill.integer("origin", [&](E, std::size_t i) { return origin_of(frame, i) + 1; });
  if (!field.elements.empty() && !field.is_of_blocks)
    fill.integer("body", [&](E, std::size_t i) { return field.elements[i].body + 1; });
  fill.integer("material", [](E e, std::size_t) { return e.material + 1; });
  fill.integer("fixed_points", [&](E, std::size_t i) {
    const auto found = fixed.find(number_of(frame, i));
    return found == fixed.end() ? 0 : found->second;
  });
  fill.xy("centroid", [](E e) { return e.centroid; });
  fill.xy("displacement", [](E e) { return e.displacement; });
  fill.real("rotation", [](E e) { return e.rotation; });
  fill.xy(
      "velocity",
      [](E e) {
        return Point{e.velocity.x, e.velocity.y};
      },
      Digits::seven);
  fill.real(
      "rotation_rate", [](E e) { return e.velocity.rotation; }, Digits::seven);
  fill.tensor("stress", [](E e) { return components(e.stress); });
  fill.real(
      "area", [](E e) { return e.area; }, Digits::seven);
  if (frame.plastic) {
    add_plastic(fill);
    fill.integer("yield_state", [](E e, std::size_t) { return static_cast<int>(plastic_of(e).region); });
    fill.integer("has_yielded", [](E e, std::size_t) { return plastic_of(e).has_yielded ? 1 : 0; });
  }
  return part;
}

FramePart loops_of(const Frame& frame) {
  struct Loop {
    int row;
    int corners;
  };
  std::vector<Loop> loops;
  loops.reserve(frame.elements.size());
  for (std::size_t i = 0; i < frame.elements.size(); ++i)
    for (const std::vector<Point>& loop : frame.elements[i].loops)
      loops.push_back({static_cast<int>(i), static_cast<int>(loop.size())});
  FramePart part{"loops", loops.size(), {}};
  const ColumnFiller fill(part, loops);
  fill.integer("row", [](const Loop& l, std::size_t) { return l.row; });
  fill.integer("corners", [](const Loop& l, std::size_t) { return l.corners; });
  return part;
}

std::size_t corner_count(const Frame& frame) {
  std::size_t count = 0;
  for (const ElementFrame& element : frame.elements)
    for (const std::vector<Point>& loop : element.loops) count += loop.size();
  return count;
}

FramePart corners_of(const Frame& frame, const FieldFrame& field) {
  struct Place {
    int row;
    Point at;
  };
  std::vector<Place> places;
  places.reserve(corner_count(frame));
  for (std::size_t i = 0; i < frame.elements.size(); ++i)
    for (const std::vector<Point>& loop : frame.elements[i].loops)
      for (const Point& corner : loop) places.push_back({static_cast<int>(i), corner});
  FramePart part{"corners", places.size(), {}};
  const ColumnFiller fill(part, places);
  fill.integer("row", [](const Place& p, std::size_t) { return p.row; });
  fill.xy("place", [](const Place& p) { return p.at; });
  if (field.elements.empty()) return part;
  std::vector<const FieldCorner*> corners;
  corners.reserve(places.size());
  for (const FieldElement& element : field.elements)
    for (const std::vector<FieldCorner>& loop : element.loops)
      for (const FieldCorner& corner : loop) corners.push_back(&corner);
  const ColumnFiller within(part, corners);
  within.xy("displacement", [](const FieldCorner* c) { return c->displacement; });
  if (field.is_of_blocks || field.is_uniform) return part;
  within.tensor("stress", [](const FieldCorner* c) { return components(c->stress); });
  if (field.plastic) add_plastic(within);
  return part;
}

FramePart bolts_of(const Frame& frame) {
  using B = const BoltFrame&;
  FramePart part{"bolts", frame.bolts.size(), {}};
  const ColumnFiller fill(part, frame.bolts);
  fill.integer("bolt", [](B b, std::size_t i) { return (b.number < 0 ? static_cast<int>(i) : b.number) + 1; });
  fill.ends("ends", [](B b) { return Ends{b.first, b.second}; });
  fill.real("force", [](B b) { return b.force; });
  fill.integer("is_broken", [](B b, std::size_t) { return b.is_broken ? 1 : 0; });
  return part;
}

FramePart cracks_of(const FieldFrame& field) {
  struct Face {
    std::size_t crack;
    bool is_shear;
    const CrackFace* edge;
  };
  std::vector<Face> faces;
  for (std::size_t c = 0; c < field.cracks.size(); ++c)
    for (const CrackFace& edge : field.cracks[c].faces) faces.push_back({c, field.cracks[c].is_shear, &edge});
  using F = const Face&;
  FramePart part{"cracks", faces.size(), {}};
  const ColumnFiller fill(part, faces);
  fill.integer("crack", [](F f, std::size_t) { return static_cast<int>(f.crack) + 1; });
  fill.integer("side", [](F f, std::size_t) { return f.edge->is_left ? 1 : 0; });
  fill.integer("is_shear", [](F f, std::size_t) { return f.is_shear ? 1 : 0; });
  fill.ends("ends", [](F f) {
    const auto& [a, b] = f.edge->ends;
    return Ends{a.position + a.displacement, b.position + b.displacement};
  });
  fill.ends("displacement", [](F f) { return Ends{f.edge->ends[0].displacement, f.edge->ends[1].displacement}; });
  return part;
}

FramePart points_of(const Frame& frame) {
  using P = const PointFrame&;
  FramePart part{"points", frame.measured_points.size(), {}};
  const ColumnFiller fill(part, frame.measured_points);
  fill.integer("point", [](P p, std::size_t i) { return (p.number < 0 ? static_cast<int>(i) : p.number) + 1; });
  fill.xy("place", [](P p) { return p.position; });
  fill.xy("displacement", [](P p) { return p.displacement; });
  fill.tensor("stress", [](P p) { return components(p.stress); });
  return part;
}

FramePart tips_of(const Frame& frame) {
  using T = const TipState&;
  FramePart part{"tips", frame.tips.size(), {}};
  const ColumnFiller fill(part, frame.tips);
  fill.integer("crack", [](T t, std::size_t) { return t.crack + 1; });
  fill.integer("at_end", [](T t, std::size_t) { return t.at_end ? 1 : 0; });
  fill.xy("place", [](T t) { return t.at; });
  fill.real("K_I", [](T t) { return t.mode_1; });
  fill.real("K_II", [](T t) { return t.mode_2; });
  fill.real("J", [](T t) { return t.energy_release; });
  fill.real("length", [](T t) { return t.length; });
  return part;
}

}  // namespace

const FramePart& FrameColumns::part(std::string_view name) const {
  const auto found = std::ranges::find(parts, name, &FramePart::name);
  if (found != parts.end()) return *found;
  std::vector<std::string_view> names;
  for (const FramePart& p : parts) names.push_back(p.name);
  throw std::invalid_argument(
      fmt::format("expected a part of a frame ({}), found \"{}\"", fmt::join(names, ", "), name));
}

FrameColumns columns_of(const Frame& frame, const ContactFrames& contacts, const FieldFrame& field, FrameStage stage) {
  return {frame.step,
          frame.time,
          frame.load_factor,
          {blocks_of(frame, field), loops_of(frame), corners_of(frame, field), contact_part(contacts), bolts_of(frame),
           cracks_of(field), points_of(frame), tips_of(frame)},
          std::move(stage)};
}

}  // namespace keyblock::formats
