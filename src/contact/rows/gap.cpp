// Computes the rows from the points of a contact.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rows/gap.hpp"

#include "base/loop.hpp"
#include "contact/rows/point_motion.hpp"

namespace keyblock {
namespace {

class Rows {
 public:
  Rows(const Model& model, const Reference& reference, const UnknownsTable& q, const Touches& touches)
      : model_(model), points_(model, reference, q), vertices_(vertices_at(model, reference, q)) {
    std::vector<ElementIndex> elements;
    for (const Touch& touch : touches)
      for (const VertexIndex v : {touch.vertex, touch.start}) elements.push_back(model.vertices[v].element);
    points_.prepare(elements);
  }

  void make(const Touch& touch, ContactRow& normal, ContactRow& tangential) const {
    const ElementIndex a = model_.vertices[touch.vertex].element;
    const ElementIndex b = model_.vertices[touch.start].element;
    const Point n = normal_of(touch, vertices_);
    if (touch.kind == TouchKind::arc) {
      const Point p = place_of(touch);
      const PointMotion on_a = points_.at_place(a, p), on_b = points_.at_place(b, p);
      normal = row_between(a, on_a, b, on_b, n);
      tangential = row_between(a, on_a, b, on_b, {-n.y, n.x});
      return;
    }
    const PointMotion at_point = of_point(touch);
    normal = row_between(a, at_point, b, of_foot(touch), n);
    tangential = row_between(a, at_point, b, points_.at_place(b, point_of(touch, vertices_)), {-n.y, n.x});
  }

 private:
  PointMotion of_point(const Touch& touch) const {
    if (touch.kind != TouchKind::middle) return points_.of_vertex(touch.vertex);
    return between(points_.of_vertex(touch.vertex), points_.of_vertex(touch.other), touch.along);
  }
  // Returns the point of an arc. On a line it is the corner that the edge guides, between them it follows the normal.
  Point place_of(const Touch& arc) const {
    const Point first = vertices_[guided(arc, arc.first).vertex], second = vertices_[guided(arc, arc.second).vertex];
    return first + share_of_second(arc, vertices_) * (second - first);
  }
  // The foot divides the edge in proportion s.
  PointMotion of_foot(const Touch& touch) const {
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
  const Rows maker(model, reference, q, touches);
  rows.resize(2 * touches.size());
  for_each_entry(touches.size(), [&](std::size_t i) { maker.make(touches[i], rows[2 * i], rows[2 * i + 1]); });
  return rows;
}

}  // namespace keyblock
