// Computes the rows of bolts and fixed points from the derivatives of their material points.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rows/constraints.hpp"

#include "contact/rows/point_motion.hpp"

namespace keyblock {
namespace {

class MovedPoints {
 public:
  MovedPoints(const Model& model, const Reference& reference, const UnknownsTable& q)
      : model_(model), reference_(reference), q_(q), motions_(model, reference, q) {}

  Point place(ElementIndex e, Point start) const { return point_at(model_, reference_, q_, e, start); }
  PointMotion motion(const MaterialPoint& point) const { return motions_.of_point(point.element, point.start); }
  PointMotion motion(const CarriedPoint& point) const { return motions_.of_point(point.element, point.start); }
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

Eigen::VectorXd pairs_of(const std::vector<Point>& points) {
  Eigen::VectorXd pairs(2 * static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    pairs.segment<2>(2 * static_cast<Eigen::Index>(i)) << points[i].x, points[i].y;
  return pairs;
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

std::vector<CarriedPoint> held_points(const Model& model) {
  std::vector<CarriedPoint> held;
  for (const CarriedPoint& point : model.fixed_points)
    if (model.elements[point.element].can_move()) held.push_back(point);
  return held;
}

ContactRows point_rows(const Model& model, const Reference& reference, const UnknownsTable& q,
                       const std::vector<CarriedPoint>& points) {
  const MovedPoints moved(model, reference, q);
  ContactRows rows;
  for (const CarriedPoint& point : points) {
    const PointMotion motion = moved.motion(point);
    rows.push_back(row_of(point.element, motion, {1, 0}));
    rows.push_back(row_of(point.element, motion, {0, 1}));
  }
  return rows;
}

Eigen::VectorXd offsets(const Model& model, const Reference& reference, const UnknownsTable& q,
                        const std::vector<CarriedPoint>& points, double time) {
  const MovedPoints moved(model, reference, q);
  std::vector<Point> result;
  for (const CarriedPoint& point : points)
    result.push_back(moved.place(point.element, point.start) - (point.start + point.curve.at(time)));
  return pairs_of(result);
}

Eigen::VectorXd wanted_velocities(const std::vector<CarriedPoint>& points, double time, double dt) {
  std::vector<Point> result;
  for (const CarriedPoint& point : points)
    result.push_back((1 / dt) * (point.curve.at(time + dt) - point.curve.at(time)));
  return pairs_of(result);
}

}  // namespace keyblock
