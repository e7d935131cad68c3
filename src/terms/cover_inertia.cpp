// Products of functions, integrated monomial by monomial; see cover_inertia.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_inertia.hpp"

namespace keyblock {
namespace {

Eigen::VectorXd moments_of(const Continuum& continuum, int element, const ElementShape& shape, int degree) {
  const auto loops = continuum.manifold.polygon(continuum.manifold.elements[static_cast<std::size_t>(element)]);
  return polygon_moments(loops, shape.frame, degree);
}

}  // namespace

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
  for (int e = 0; e < basis.element_count(); ++e) {
    const ElementShape shape = basis.shape(e);
    const Eigen::VectorXd moments = moments_of(continuum, e, shape, 2 * shape.degree);
    const Eigen::MatrixXd mass = cover_mass(shape, moments, continuum.material(e).density);
    Eigen::MatrixXd both = Eigen::MatrixXd::Zero(2 * mass.rows(), 2 * mass.cols());
    for (Eigen::Index a = 0; a < mass.rows(); ++a) {
      for (Eigen::Index b = 0; b < mass.cols(); ++b) both(2 * a, 2 * b) = both(2 * a + 1, 2 * b + 1) = mass(a, b);
    }
    system.add_matrix(shape.functions, both);
  }
}

Eigen::VectorXd cover_weight(const Continuum& continuum, const CoverBasis& basis, Point acceleration) {
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(2 * basis.function_count());
  for (int e = 0; e < basis.element_count(); ++e) {
    const ElementShape shape = basis.shape(e);
    const Eigen::VectorXd share =
        continuum.material(e).density * shape.monomial.transpose() * moments_of(continuum, e, shape, shape.degree);
    for (Eigen::Index a = 0; a < share.size(); ++a)
      weight.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]) +=
          share(a) * Eigen::Vector2d(acceleration.x, acceleration.y);
  }
  return weight;
}

}  // namespace keyblock
