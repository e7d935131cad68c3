// Computes the map of an element and its derivative. Rotation and strain refer to the rotated frame, the translation
// does not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/kinematics.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/loop.hpp"
#include "model/state.hpp"

namespace keyblock {
namespace {

Eigen::Matrix2d rotation_matrix(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return Eigen::Matrix2d{{c, -s}, {s, c}};
}

// Most operators have this size, which the compiler knows.
using OfWholeBlock = Eigen::Matrix<double, 2, kMostUnknowns>;

Eigen::Vector2d product(const DisplacementOperator& rows, const Unknowns& q) {
  if (q.size() != kMostUnknowns) return rows * q;
  return Eigen::Map<const OfWholeBlock>(rows.data()) *
         Eigen::Map<const Eigen::Matrix<double, kMostUnknowns, 1>>(q.data());
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
  reference.centroids.reserve(model.elements.size());
  reference.moments.reserve(model.elements.size());
  reference.offsets.reserve(model.vertices.size());
  for (ElementIndex e : indices(model.elements)) {
    const Placement placement = place(model, vertices, e, settings);
    reference.centroids.push_back(placement.centroid);
    reference.moments.push_back(placement.moments);
  }
  for (VertexIndex v : indices(model.vertices))
    reference.offsets.push_back(vertices[v] - reference.centroids[model.vertices[v].element]);
  return reference;
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
  return point_of(product(basis.constant, q));
}

BlockMap::BlockMap(const Basis& basis, const Unknowns& q, Point centroid_at_start)
    : centroid_(centroid_at_start + translation(basis, q)), rotation_(rotation_matrix(angle_of(basis, q))) {
  const Unknowns strain = without_rotation(basis, q);
  Eigen::Matrix2d stretch = Eigen::Matrix2d::Identity();
  stretch.col(0) += product(basis.per_x, strain);
  stretch.col(1) += product(basis.per_y, strain);
  a_ = rotation_ * stretch;
}

Point BlockMap::offset(Point place) const {
  const Point from_centroid = place - centroid_;
  return point_of(a_.inverse() * Eigen::Vector2d(from_centroid.x, from_centroid.y));
}

// Rotation of the frame moves a point perpendicular to its arm.
BlockJacobian::BlockJacobian(const Basis& basis, const Unknowns& q, const BlockMap& map)
    : constant_(basis.constant), per_x_(map.rotation() * basis.per_x), per_y_(map.rotation() * basis.per_y) {
  if (basis.rotation_unknown < 0 || q.size() == 0) return;
  const Eigen::Matrix2d& a = map.gradient();
  per_x_.col(basis.rotation_unknown) = Eigen::Vector2d(-a(1, 0), a(0, 0));
  per_y_.col(basis.rotation_unknown) = Eigen::Vector2d(-a(1, 1), a(0, 1));
}

DisplacementOperator BlockJacobian::at(Point offset) const {
  if (constant_.cols() != kMostUnknowns) return constant_ + offset.x * per_x_ + offset.y * per_y_;
  const auto whole = [](const DisplacementOperator& part) { return Eigen::Map<const OfWholeBlock>(part.data()); };
  return whole(constant_) + offset.x * whole(per_x_) + offset.y * whole(per_y_);
}

DisplacementOperator jacobian(const Basis& basis, const Unknowns& q, Point offset) {
  return BlockJacobian(basis, q, BlockMap(basis, q, {})).at(offset);
}

void UnknownsTable::set_zero() {
  for (Unknowns& of : *this) of.setZero();
  shared.setZero();
}

bool UnknownsTable::all_finite() const {
  return std::ranges::all_of(*this, [](const Unknowns& of) { return of.allFinite(); }) && shared.allFinite();
}

UnknownsTable& UnknownsTable::operator*=(double factor) {
  for (Unknowns& of : *this) of *= factor;
  shared *= factor;
  return *this;
}

bool operator==(const UnknownsTable& a, const UnknownsTable& b) {
  const Table<ElementIndex, Unknowns>& blocks = a;
  return blocks == b && a.shared.size() == b.shared.size() && a.shared == b.shared;
}

Point point_at(const Model& model, const Reference& reference, const UnknownsTable& q, ElementIndex element,
               Point start) {
  if (reference.is_on_covers(element)) return moved(start, reference.covers->shares(element, start), q.shared);
  const Point centroid = reference.centroids[element];
  return BlockMap(*model.elements[element].basis, q[element], centroid).place(start - centroid);
}

Table<VertexIndex, Point> vertices_at(const Model& model, const Reference& reference, const UnknownsTable& q) {
  Table<VertexIndex, Point> vertices(model.vertices.size());
  for_each_entry(model.elements.size(), [&](std::size_t i) {
    const ElementIndex e{static_cast<int>(i)};
    if (reference.is_on_covers(e)) {
      for (VertexIndex v : model.elements[e].vertices())
        vertices[v] =
            moved(model.start_vertices[static_cast<std::size_t>(v.value)], reference.covers->of_vertex(v), q.shared);
      return;
    }
    const BlockMap map(*model.elements[e].basis, q[e], reference.centroids[e]);
    for (VertexIndex v : model.elements[e].vertices()) vertices[v] = map.place(reference.offsets[v]);
  });
  return vertices;
}

double dot(const UnknownsTable& a, const UnknownsTable& b) {
  double sum = 0;
  for (ElementIndex e : indices(a)) sum += a[e].dot(b[e]);
  return sum + a.shared.dot(b.shared);
}

UnknownsTable plus(const UnknownsTable& a, double s, const UnknownsTable& b) {
  UnknownsTable sum = a;
  for (ElementIndex e : indices(sum)) sum[e] += s * b[e];
  sum.shared += s * b.shared;
  return sum;
}

}  // namespace keyblock
