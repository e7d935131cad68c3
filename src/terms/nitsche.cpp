// Edge by edge; see nitsche.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/nitsche.hpp"

#include "geometry/quadrature.hpp"
#include "geometry/segment.hpp"
#include "terms/stabilisation.hpp"

namespace keyblock {
namespace {

Eigen::Matrix2d projector(Held held, Point normal) {
  const Eigen::Vector2d n(normal.x, normal.y);
  switch (held) {
    case Held::both:
      return Eigen::Matrix2d::Identity();
    case Held::normal:
      return n * n.transpose();
    case Held::x:
      return Eigen::Vector2d::UnitX() * Eigen::RowVector2d::UnitX();
    case Held::y:
      return Eigen::Vector2d::UnitY() * Eigen::RowVector2d::UnitY();
  }
  return Eigen::Matrix2d::Zero();
}

/// σn = S σ.
Eigen::Matrix<double, 2, 3> on_plane(Point n) {
  Eigen::Matrix<double, 2, 3> s;
  s << n.x, 0, n.y, 0, n.y, n.x;
  return s;
}

}  // namespace

void add_prescribed(const Continuum& continuum, const CoverBasis& basis, const PrescribedDisplacement& prescribed,
                    SparseSystem& system) {
  for (const ElementSide& side : sides_along(continuum.manifold, prescribed.along)) {
    const ElementShape shape = basis.shape(side.element);
    const Eigen::Matrix3d modulus = continuum.modulus(side.element);
    const Eigen::Matrix2d p = projector(prescribed.held, side.normal());
    const double beta =
        stabilisation(basis.functions()).nitsche * shape.degree * shape.degree * modulus(0, 0) / shape.frame.size;
    const Eigen::Index n = 2 * shape.function_count();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
    const double all = length(side.edge.end - side.edge.start);
    for (const GaussPoint& g : gauss_rule(shape.degree + 2)) {
      const Point x = point_at(side.edge, g.at);
      const Point value = prescribed.value(x);
      const Eigen::Matrix2Xd t = p * shape.displacement(x);
      const Eigen::Matrix2Xd traction = on_plane(side.normal()) * modulus * shape.strain(x);
      const Eigen::MatrixXd cross = traction.transpose() * t;
      matrix += all * g.weight * (beta * t.transpose() * t - cross - cross.transpose());
      load += all * g.weight * ((beta * t - p * traction).transpose() * Eigen::Vector2d(value.x, value.y));
    }
    system.add_matrix(shape.functions, matrix);
    system.add_load(shape.functions, load);
  }
}

}  // namespace keyblock
