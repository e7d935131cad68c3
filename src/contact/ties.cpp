// Rows of bolts and held points from the derivatives of their material points.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/ties.hpp"

namespace keyblock {
namespace {

using Row = ContactRow::Row;

class MovedPoints {
 public:
  MovedPoints(const Model& model, const Reference& reference, const UnknownsTable& q)
      : model_(model), reference_(reference), q_(q) {}

  Point place(ElementIndex e, Point start) const { return point_at(model_, reference_, q_, e, start); }
  DisplacementOperator derivative(ElementIndex e, Point start) const {
    return jacobian(*model_.elements[e].basis, q_[e], start - reference_.centroids[e]);
  }
  Segment ends(const Bolt& bolt) const {
    return {place(bolt.first.element, bolt.first.start), place(bolt.second.element, bolt.second.start)};
  }

 private:
  const Model& model_;
  const Reference& reference_;
  const UnknownsTable& q_;
};

ContactRow against_plane(ElementIndex e, Row row) {
  Row nothing = Row::Zero(row.size());
  return {e, e, std::move(row), std::move(nothing)};
}

// Velocity of the second end against the first in the given direction.
ContactRow bolt_row(const Bolt& bolt, const MovedPoints& points, Eigen::RowVector2d direction) {
  const ElementIndex first = bolt.first.element;
  const ElementIndex second = bolt.second.element;
  const Row of_first = -direction * points.derivative(first, bolt.first.start);
  const Row of_second = direction * points.derivative(second, bolt.second.start);
  if (first == second) return against_plane(first, of_first + of_second);
  return {second, first, of_second, of_first};
}

Eigen::RowVector2d direction_of(const Segment& bolt) {
  const double size = distance(bolt.start, bolt.end);
  if (size == 0) return Eigen::RowVector2d::Zero();
  return Eigen::RowVector2d(bolt.end.x - bolt.start.x, bolt.end.y - bolt.start.y) / size;
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
    const Eigen::RowVector2d along = direction_of(points.ends(bolt));
    rows.push_back(bolt_row(bolt, points, along));
    rows.push_back(bolt_row(bolt, points, {-along.y(), along.x()}));
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
    if (model.elements[point.element].basis->unknown_count() > 0) held.push_back(point);
  return held;
}

ContactRows point_rows(const Model& model, const Reference& reference, const UnknownsTable& q,
                       const std::vector<CarriedPoint>& points) {
  const MovedPoints moved(model, reference, q);
  ContactRows rows;
  for (const CarriedPoint& point : points) {
    const DisplacementOperator velocity = moved.derivative(point.element, point.start);
    rows.push_back(against_plane(point.element, velocity.row(0)));
    rows.push_back(against_plane(point.element, velocity.row(1)));
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
