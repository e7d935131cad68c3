// The map of an element and its derivative; the translation is not turned, rotation and strain are.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/kinematics.hpp"

#include <Eigen/LU>
#include <cmath>

#include "model/state.hpp"

namespace keyblock {
namespace {

Eigen::Matrix2d rotation_matrix(double angle) {
  return Eigen::Matrix2d{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
}

Unknowns without_rotation(const Basis& basis, Unknowns q) {
  if (basis.rotation_unknown >= 0) q[basis.rotation_unknown] = 0;
  return q;
}

Point point_of(const Eigen::Vector2d& v) {
  return {v.x(), v.y()};
}

}  // namespace

Reference reference_of(const Model& model, const Settings& settings) {
  Reference reference;
  Table<VertexIndex, Point> vertices;
  vertices.assign(model.start_vertices.begin(), model.start_vertices.end());
  for (ElementIndex e : indices(model.elements)) {
    const Placement placement = place(model, vertices, e, settings);
    reference.centroids.push_back(placement.centroid);
    reference.moments.push_back(placement.moments);
  }
  for (VertexIndex v : indices(model.vertices))
    reference.offsets.push_back(vertices[v] - reference.centroids[model.vertices[v].element]);
  return reference;
}

Point stretched(const Basis& basis, const Unknowns& q, Point offset) {
  const DisplacementOperator gradient = offset.x * basis.per_x + offset.y * basis.per_y;
  return offset + point_of(gradient * without_rotation(basis, q));
}

Point turned(Point p, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

double angle_of(const Basis& basis, const Unknowns& q) {
  return basis.rotation_unknown < 0 ? 0 : q[basis.rotation_unknown];
}

Point translation(const Basis& basis, const Unknowns& q) {
  return point_of(basis.constant * q);
}

DisplacementOperator jacobian(const Basis& basis, const Unknowns& q, Point offset) {
  if (basis.unknown_count() == 0) return basis.constant;
  const double angle = angle_of(basis, q);
  DisplacementOperator gradient = rotation_matrix(angle) * (offset.x * basis.per_x + offset.y * basis.per_y);
  if (basis.rotation_unknown >= 0) {
    const Point arm = turned(stretched(basis, q, offset), angle);
    gradient.col(basis.rotation_unknown) = Eigen::Vector2d(-arm.y, arm.x);
  }
  return basis.constant + gradient;
}

Point material_offset(const Basis& basis, const Unknowns& q, Point from_centroid) {
  const Point local = turned(from_centroid, -angle_of(basis, q));
  const Unknowns strain = without_rotation(basis, q);
  Eigen::Matrix2d stretch = Eigen::Matrix2d::Identity();
  stretch.col(0) += basis.per_x * strain;
  stretch.col(1) += basis.per_y * strain;
  return point_of(stretch.inverse() * Eigen::Vector2d(local.x, local.y));
}

void UnknownsTable::set_zero() {
  for (Unknowns& of : *this) of.setZero();
  covers.setZero();
}

UnknownsTable& UnknownsTable::operator*=(double factor) {
  for (Unknowns& of : *this) of *= factor;
  covers *= factor;
  return *this;
}

bool operator==(const UnknownsTable& a, const UnknownsTable& b) {
  const Table<ElementIndex, Unknowns>& blocks = a;
  return blocks == b && a.covers.size() == b.covers.size() && a.covers == b.covers;
}

Point point_at(const Model& model, const Reference& reference, const UnknownsTable& q, ElementIndex element,
               Point start) {
  if (reference.is_on_covers(element)) return moved(start, reference.covers->shares(element, start), q.covers);
  const Basis& basis = *model.elements[element].basis;
  const Point centroid = reference.centroids[element];
  const Point arm = turned(stretched(basis, q[element], start - centroid), angle_of(basis, q[element]));
  return centroid + translation(basis, q[element]) + arm;
}

Table<VertexIndex, Point> vertices_at(const Model& model, const Reference& reference, const UnknownsTable& q) {
  Table<VertexIndex, Point> vertices(model.vertices.size());
  for (ElementIndex e : indices(model.elements)) {
    if (reference.is_on_covers(e)) {
      for (VertexIndex v : model.elements[e].vertices())
        vertices[v] =
            moved(model.start_vertices[static_cast<std::size_t>(v.value)], reference.covers->of_vertex(v), q.covers);
      continue;
    }
    const Basis& basis = *model.elements[e].basis;
    const Point centroid = reference.centroids[e] + translation(basis, q[e]);
    const double angle = angle_of(basis, q[e]);
    for (VertexIndex v : model.elements[e].vertices())
      vertices[v] = centroid + turned(stretched(basis, q[e], reference.offsets[v]), angle);
  }
  return vertices;
}

UnknownsTable plus(const UnknownsTable& a, double s, const UnknownsTable& b) {
  UnknownsTable sum = a;
  for (ElementIndex e : indices(sum)) sum[e] += s * b[e];
  sum.covers += s * b.covers;
  return sum;
}

}  // namespace keyblock
