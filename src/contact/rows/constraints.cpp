// Computes the rows of bolts and fixed points from the derivatives of their material points.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rows/constraints.hpp"

#include <algorithm>

#include "contact/rows/point_motion.hpp"

namespace keyblock {
namespace {

class MovedPoints {
 public:
  MovedPoints(const Model& model, const Reference& reference, const UnknownsTable& q)
      : model_(model), reference_(reference), q_(q), motions_(model, reference, q) {}

  Point place(ElementIndex e, Point start) const { return point_at(model_, reference_, q_, e, start); }
  PointMotion motion(const MaterialPoint& point) const { return motions_.of_point(point.element, point.start); }
  Segment ends(const Bolt& bolt) const {
    return {place(bolt.first.element, bolt.first.start), place(bolt.second.element, bolt.second.start)};
  }

 private:
  const Model& model_;
  const Reference& reference_;
  const UnknownsTable& q_;
  PointMotions motions_;
};

// Returns the row of the velocity of the second end against the first in the given direction.
ContactRow bolt_row(const Bolt& bolt, const MovedPoints& points, Point direction) {
  const ElementIndex first = bolt.first.element;
  const ElementIndex second = bolt.second.element;
  ContactRow row = row_between(second, points.motion(bolt.second), first, points.motion(bolt.first), direction);
  if (first != second) return row;
  row.of_vertex += row.of_edge;
  row.of_edge.setZero();
  return row;
}

Point direction_of(const Segment& bolt) {
  const double size = distance(bolt.start, bolt.end);
  return size == 0 ? Point{} : (1 / size) * (bolt.end - bolt.start);
}

TimeCurve motion_of(const SupportRow& row) {
  const Point value = row.value * row.direction;
  if (value == Point{}) return {};
  if (row.factor.times.empty()) return {{0}, {value}, {}};
  TimeCurve curve = row.factor;
  for (Point& p : curve.values) p = p.x * value;
  return curve;
}

// Returns the components along their directions of two vectors per pair.
template <class VectorsOf>
Eigen::VectorXd entries_of(const std::vector<HeldPair>& pairs, const VectorsOf& vectors_of) {
  Eigen::VectorXd entries(2 * static_cast<Eigen::Index>(pairs.size()));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::array<Point, 2> vectors = vectors_of(pairs[i]);
    for (std::size_t k = 0; k < 2; ++k)
      entries[static_cast<Eigen::Index>(2 * i + k)] = dot(pairs[i].directions[k], vectors[k]);
  }
  return entries;
}

}  // namespace

ContactRows bolt_rows(const Model& model, const Reference& reference, const UnknownsTable& q) {
  const MovedPoints points(model, reference, q);
  ContactRows rows;
  for (const Bolt& bolt : model.bolts) {
    const Point along = direction_of(points.ends(bolt));
    rows.push_back(bolt_row(bolt, points, along));
    rows.push_back(bolt_row(bolt, points, {-along.y, along.x}));
  }
  return rows;
}

Eigen::VectorXd elongations(const Model& model, const Reference& reference, const UnknownsTable& q) {
  const MovedPoints points(model, reference, q);
  Eigen::VectorXd result(static_cast<Eigen::Index>(model.bolts.size()));
  for (std::size_t i = 0; i < model.bolts.size(); ++i) {
    const Segment now = points.ends(model.bolts[i]);
    result[static_cast<Eigen::Index>(i)] = distance(now.start, now.end) - model.bolts[i].start_length();
  }
  return result;
}

bool HeldPair::is_same_at(double from, double to) const {
  return std::ranges::all_of(curves, [&](const TimeCurve& curve) { return curve.at(from) == curve.at(to); });
}

std::vector<HeldPair> held_pairs(const Model& model) {
  std::vector<HeldPair> held;
  for (const CarriedPoint& point : model.fixed_points)
    if (model.elements[point.element].can_move())
      held.push_back(
          {point.element, {point.start, point.start}, {Point{1, 0}, Point{0, 1}}, {point.curve, point.curve}});
  for (std::size_t i = 0; i < model.support_rows.size(); ++i) {
    const SupportRow& first = model.support_rows[i];
    const bool has_second = i + 1 < model.support_rows.size() && model.support_rows[i + 1].element == first.element;
    const SupportRow& second = model.support_rows[has_second ? ++i : i];
    held.push_back({first.element,
                    {first.start, second.start},
                    {first.direction, second.direction},
                    {motion_of(first), motion_of(second)}});
  }
  return held;
}

ContactRows point_rows(const Model& model, const Reference& reference, const UnknownsTable& q,
                       const std::vector<HeldPair>& pairs) {
  const MovedPoints moved(model, reference, q);
  ContactRows rows;
  for (const HeldPair& pair : pairs) {
    const PointMotion first = moved.motion(MaterialPoint{pair.starts[0], pair.element});
    rows.push_back(row_of(pair.element, first, pair.directions[0]));
    const PointMotion second = pair.is_point() ? first : moved.motion(MaterialPoint{pair.starts[1], pair.element});
    rows.push_back(row_of(pair.element, second, pair.directions[1]));
  }
  return rows;
}

Eigen::VectorXd offsets(const Model& model, const Reference& reference, const UnknownsTable& q,
                        const std::vector<HeldPair>& pairs, double time) {
  const MovedPoints moved(model, reference, q);
  return entries_of(pairs, [&](const HeldPair& pair) -> std::array<Point, 2> {
    const Point first = moved.place(pair.element, pair.starts[0]);
    const Point second = pair.is_point() ? first : moved.place(pair.element, pair.starts[1]);
    return {first - (pair.starts[0] + pair.curves[0].at(time)), second - (pair.starts[1] + pair.curves[1].at(time))};
  });
}

Eigen::VectorXd wanted_velocities(const std::vector<HeldPair>& pairs, double time, double dt) {
  return entries_of(pairs, [&](const HeldPair& pair) -> std::array<Point, 2> {
    const auto velocity = [&](const TimeCurve& curve) { return (1 / dt) * (curve.at(time + dt) - curve.at(time)); };
    return {velocity(pair.curves[0]), velocity(pair.curves[1])};
  });
}

}  // namespace keyblock
