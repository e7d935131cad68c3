// Integrates products of functions, monomial by monomial; see cover_inertia.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_inertia.hpp"

#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

constexpr double kSmallPiece = 0.01;  // per area of its triangle

Eigen::MatrixXd mass_by_points(const Continuum& continuum, int element, const ElementShape& shape) {
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(shape.function_count(), shape.function_count());
  for (const AreaPoint& point : area_rule(continuum.manifold, element, shape, 2 * shape.degree)) {
    const Eigen::RowVectorXd values = shape.values(point.at);
    mass += point.weight * values.transpose() * values;
  }
  return continuum.material(element).density * mass;
}

Eigen::VectorXd moments_of(const Continuum& continuum, int element, const ElementShape& shape, int degree) {
  const auto loops = continuum.manifold.polygon(continuum.manifold.elements[static_cast<std::size_t>(element)]);
  return polygon_moments(loops, shape.frame, degree);
}

}  // namespace

bool is_small_piece(const Manifold& manifold, int element) {
  const ManifoldElement& piece = manifold.elements[static_cast<std::size_t>(element)];
  double covered = 0;
  for (const std::vector<Point>& loop : manifold.polygon(piece)) covered += area(loop);
  return covered < kSmallPiece * area(manifold.triangle(piece));
}

Eigen::MatrixXd monomial_mass(int degree, const Eigen::VectorXd& moments, double density) {
  const std::vector<Exponents> list = exponents(degree);
  const auto n = static_cast<Eigen::Index>(list.size());
  Eigen::MatrixXd of_monomials(n, n);
  for (Eigen::Index a = 0; a < n; ++a) {
    for (Eigen::Index b = 0; b < n; ++b) {
      const Exponents p = list[static_cast<std::size_t>(a)];
      const Exponents q = list[static_cast<std::size_t>(b)];
      of_monomials(a, b) = density * moments(monomial(p.x + q.x, p.y + q.y));
    }
  }
  return of_monomials;
}

Eigen::MatrixXd cover_mass(const ElementShape& shape, const Eigen::VectorXd& moments, double density) {
  return shape.monomial.transpose() * monomial_mass(shape.degree, moments, density) * shape.monomial;
}

void add_cover_mass(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system) {
  // Functions of linear and quadratic covers are dependent. If a piece is too thin for them, the mass shows it and the
  // scene is refused: it would move by forces without mass.
  const bool are_independent =
      continuum.functions == CoverFunctions::constant || continuum.functions == CoverFunctions::derived;
  Eigen::MatrixXd both;
  for (int e = 0; e < basis.element_count(); ++e) {
    const ElementShape shape = basis.shape(e);
    const Eigen::MatrixXd mass =
        are_independent && is_small_piece(continuum.manifold, e)
            ? mass_by_points(continuum, e, shape)
            : cover_mass(shape, moments_of(continuum, e, shape, 2 * shape.degree), continuum.material(e).density);
    both.setZero(2 * mass.rows(), 2 * mass.cols());
    for (Eigen::Index a = 0; a < mass.rows(); ++a) {
      for (Eigen::Index b = 0; b < mass.cols(); ++b) both(2 * a, 2 * b) = both(2 * a + 1, 2 * b + 1) = mass(a, b);
    }
    system.add_matrix(shape.functions, both);
  }
}

}  // namespace keyblock
