// Evaluates the functions at the vertices once, because they do not change.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cover_kinematics.hpp"

#include <Eigen/LU>

namespace keyblock {
namespace {

// Bound on Newton iterations for the map of an element: affine elements converge in one, and a second confirms it.
constexpr int kMostSteps = 20;
// Round-off of a position, per size of the element.
constexpr double kSettled = 1e-14;

}  // namespace

CoverKinematics::CoverKinematics(const Model& model, ElementIndex first, const CoverBasis& basis)
    : basis_(basis), first_(first), first_vertex_(model.elements[first].first_vertex) {
  const IndexRange<VertexIndex> own(first_vertex_, model.vertices.end_index());
  std::size_t count = 0;
  for (VertexIndex v : own) count += basis_.shape(manifold_element(model.vertices[v].element)).functions.size();
  shares_.reserve(count);
  for (VertexIndex v : own) {
    begins_.push_back(shares_.size());
    const ElementShape shape = basis_.shape(manifold_element(model.vertices[v].element));
    const Eigen::RowVectorXd values = shape.values(model.start_vertices[static_cast<std::size_t>(v.value)]);
    for (int a = 0; a < shape.function_count(); ++a)
      shares_.push_back({shape.functions[static_cast<std::size_t>(a)], values[a]});
  }
  begins_.push_back(shares_.size());
}

std::span<const CoverShare> CoverKinematics::of_vertex(VertexIndex v) const {
  const auto i = static_cast<std::size_t>(v.value - first_vertex_.value);
  return std::span(shares_).subspan(begins_[i], begins_[i + 1] - begins_[i]);
}

std::vector<CoverShare> CoverKinematics::shares(ElementIndex e, Point start) const {
  const ElementShape shape = basis_.shape(manifold_element(e));
  const Eigen::RowVectorXd values = shape.values(start);
  std::vector<CoverShare> result;
  for (int a = 0; a < shape.function_count(); ++a)
    result.push_back({shape.functions[static_cast<std::size_t>(a)], values[a]});
  return result;
}

Point CoverKinematics::start_of(ElementIndex e, const Eigen::VectorXd& d, Point x) const {
  const ElementShape shape = basis_.shape(manifold_element(e));
  Eigen::MatrixX2d of_functions(shape.function_count(), 2);
  for (int a = 0; a < shape.function_count(); ++a)
    of_functions.row(a) = d.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]);
  Point start = shape.frame.origin;
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::RowVector2d u = shape.values(start) * of_functions;
    const Eigen::Matrix2d f = Eigen::Matrix2d::Identity() + (shape.gradients(start) * of_functions).transpose();
    const Eigen::Vector2d correction = f.inverse() * Eigen::Vector2d(x.x - start.x - u.x(), x.y - start.y - u.y());
    if (!correction.allFinite()) break;
    start = start + Point{correction.x(), correction.y()};
    if (correction.norm() <= kSettled * shape.frame.size) break;
  }
  return start;
}

Point moved(Point start, std::span<const CoverShare> shares, const Eigen::VectorXd& d) {
  for (const CoverShare& share : shares)
    start = start + share.value * Point{d[2 * share.function], d[2 * share.function + 1]};
  return start;
}

}  // namespace keyblock
