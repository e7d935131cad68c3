// Fits affine fields to point fields; see carry_blocks.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/groups/carry_blocks.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "material/mean_memory.hpp"
#include "step/bodies/standard_body.hpp"

namespace keyblock {

std::vector<std::vector<Point>> loops_of(const Model& model, ElementIndex e) {
  std::vector<std::vector<Point>> loops;
  VertexIndex v = model.elements[e].first_vertex;
  for (const int size : model.elements[e].loop_sizes) {
    loops.emplace_back();
    for (int i = 0; i < size; ++i, ++v.value)
      loops.back().push_back(model.start_vertices[static_cast<std::size_t>(v.value)]);
  }
  return loops;
}

void carry_field(const SceneParts& scene, ElementIndex e, const std::vector<FieldPoint>& field, BodiesMotion& carried) {
  const Basis& basis = *scene.model.elements[e].basis;
  Unknowns& q = carried.q[e];
  Unknowns& v = carried.v[e];
  if (q.size() == 0 || basis.rotation_unknown < 0) return;
  const Point centroid = scene.reference.centroids[e];
  double area = 0;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
  Eigen::Matrix2d places = Eigen::Matrix2d::Zero();  // Σ x Xᵀ, X from the centroid
  Eigen::Matrix2d rates = places;
  Eigen::Matrix2d moments = places;
  for (const FieldPoint& point : field) {
    const Eigen::Vector2d arm(point.start.x - centroid.x, point.start.y - centroid.y);
    const Eigen::Vector2d way(point.place.x - point.start.x, point.place.y - point.start.y);
    const Eigen::Vector2d rate(point.velocity.x, point.velocity.y);
    area += point.area;
    shift += point.area * way;
    velocity += point.area * rate;
    places += point.area * (arm + way) * arm.transpose();
    rates += point.area * rate * arm.transpose();
    moments += point.area * arm * arm.transpose();
  }
  const Eigen::Matrix2d f = places * moments.inverse();
  const double angle = std::atan2(f(1, 0) - f(0, 1), f(0, 0) + f(1, 1));
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  const Eigen::Matrix2d stretch = turn.transpose() * f;
  const Eigen::Matrix2d rate = turn.transpose() * rates * moments.inverse();
  q.setZero();
  v.setZero();
  q.head<3>() << shift / area, angle;
  v.head<3>() << velocity / area, (rate(1, 0) - rate(0, 1)) / 2;
  if (q.size() != kMostUnknowns) return;
  q.tail<3>() << stretch(0, 0) - 1, stretch(1, 1) - 1, stretch(0, 1) + stretch(1, 0);
  v.tail<3>() << rate(0, 0), rate(1, 1), rate(0, 1) + rate(1, 0);
}

YieldState carried_memory(ElementIndex old, const std::vector<FieldPoint>& field, const BodiesBefore& before) {
  MeanMemory mean;
  for (const FieldPoint& point : field)
    mean.add(point.area, before.groups.of(old).memory_at(old, before.motion, point.start));
  YieldState memory = mean.over(mean.weight());
  memory.elastic.setZero();
  return memory;
}

void carry_block(const SceneParts& scene, ElementIndex e, const BodiesBefore& before, BodiesMotion& carried) {
  const ElementIndex old = before.parents[e];
  const Basis& basis = *before.scene.model.elements[old].basis;
  const Eigen::Index count = std::min(before.motion.q[old].size(), carried.q[e].size());
  if (count == 0) return;
  const Point centroid = scene.reference.centroids[e];
  const Point offset = centroid - before.scene.reference.centroids[old];
  carried.q[e].head(count) = before.motion.q[old].head(count);
  carried.v[e].setZero();
  carried.v[e].head(count) = before.motion.v[old].head(count);
  if (offset == Point{}) return;
  const Point place = point_at(before.scene.model, before.scene.reference, before.motion.q, old, centroid);
  carried.q[e].head<2>() << place.x - centroid.x, place.y - centroid.y;
  Unknowns unstrained = before.motion.q[old];
  unstrained.tail(unstrained.size() - kRigidUnknowns).setZero();
  carried.v[e].head<2>() = jacobian(basis, unstrained, offset) * before.motion.v[old];
}

}  // namespace keyblock
