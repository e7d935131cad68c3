// Rows from the points of a touch.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/gap.hpp"

#include "contact/point_motion.hpp"

namespace keyblock {
namespace {

class Rows {
 public:
  Rows(const Model& model, const Reference& reference, const UnknownsTable& q)
      : model_(model), points_(model, reference, q), vertices_(vertices_at(model, reference, q)) {}

  void add(const Touch& touch, ContactRows& rows) const {
    const ElementIndex a = model_.vertices[touch.vertex].element;
    const ElementIndex b = model_.vertices[touch.start].element;
    const Point n = normal_of(touch, vertices_);
    const PointMotion at_point = of_point(touch);
    rows.push_back(row_between(a, at_point, b, of_foot(touch), n));
    rows.push_back(row_between(a, at_point, b, points_.at_place(b, point_of(touch, vertices_)), {-n.y, n.x}));
  }

 private:
  PointMotion of_point(const Touch& touch) const {
    if (touch.kind != TouchKind::middle) return points_.of_vertex(touch.vertex);
    return between(points_.of_vertex(touch.vertex), points_.of_vertex(touch.other), touch.along);
  }
  // With s the share of the edge at the foot of the point; a corner is met as it is.
  PointMotion of_foot(const Touch& touch) const {
    if (touch.kind == TouchKind::bisector) return points_.of_vertex(touch.other);
    const Point along = vertices_[touch.end] - vertices_[touch.start];
    const double s = dot(point_of(touch, vertices_) - vertices_[touch.start], along) / dot(along, along);
    return between(points_.of_vertex(touch.start), points_.of_vertex(touch.end), s);
  }

  const Model& model_;
  PointMotions points_;
  Table<VertexIndex, Point> vertices_;
};

}  // namespace

ContactRows contact_rows(const Model& model, const Reference& reference, const UnknownsTable& q,
                         const Touches& touches) {
  ContactRows rows;
  if (touches.empty()) return rows;
  const Rows maker(model, reference, q);
  for (const Touch& touch : touches) maker.add(touch, rows);
  return rows;
}

}  // namespace keyblock
