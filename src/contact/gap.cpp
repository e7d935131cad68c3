// Rows from the points of a touch.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/gap.hpp"

namespace keyblock {
namespace {

Eigen::RowVector2d row_vector(Point p) {
  return {p.x, p.y};
}

class Rows {
 public:
  Rows(const Model& model, const Reference& reference, const UnknownsTable& q)
      : model_(model), reference_(reference), q_(q), vertices_(vertices_at(model, reference, q)) {}

  void add(const Touch& touch, ContactRows& rows) const {
    const ElementIndex a = model_.vertices[touch.vertex].element;
    const ElementIndex b = model_.vertices[touch.start].element;
    const Point n = normal_of(touch, vertices_);
    const Point t{-n.y, n.x};
    const DisplacementOperator at_point = of_point(touch);
    rows.push_back({a, b, row_vector(n) * at_point, -row_vector(n) * of_foot(touch)});
    rows.push_back({a, b, row_vector(t) * at_point, -row_vector(t) * opposite(b, point_of(touch, vertices_))});
  }

 private:
  DisplacementOperator at(VertexIndex v) const {
    const ElementIndex e = model_.vertices[v].element;
    return jacobian(*model_.elements[e].basis, q_[e], reference_.offsets[v]);
  }
  DisplacementOperator of_point(const Touch& touch) const {
    if (touch.kind != TouchKind::middle) return at(touch.vertex);
    return (1 - touch.along) * at(touch.vertex) + touch.along * at(touch.other);
  }
  // With s the share of the edge at the foot of the point; a corner is met as it is.
  DisplacementOperator of_foot(const Touch& touch) const {
    if (touch.kind == TouchKind::bisector) return at(touch.other);
    const Point along = vertices_[touch.end] - vertices_[touch.start];
    const double s = dot(point_of(touch, vertices_) - vertices_[touch.start], along) / dot(along, along);
    return (1 - s) * at(touch.start) + s * at(touch.end);
  }
  DisplacementOperator opposite(ElementIndex e, Point x) const {
    const Basis& basis = *model_.elements[e].basis;
    const Point centroid = reference_.centroids[e] + translation(basis, q_[e]);
    return jacobian(basis, q_[e], material_offset(basis, q_[e], x - centroid));
  }

  const Model& model_;
  const Reference& reference_;
  const UnknownsTable& q_;
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
