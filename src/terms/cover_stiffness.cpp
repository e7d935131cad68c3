// Integrates products of gradients, monomial by monomial; see cover_stiffness.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_stiffness.hpp"

#include "terms/cover_inertia.hpp"

namespace keyblock {
namespace {

/// ∫ ∂φ_a/∂x ∂φ_b/∂x, ∂φ_a/∂x ∂φ_b/∂y and ∂φ_a/∂y ∂φ_b/∂y of all monomials.
struct GradientProducts {
  Eigen::MatrixXd xx, xy, yy;
};

GradientProducts gradient_products(int degree, const LocalFrame& frame, const Eigen::VectorXd& moments) {
  const std::vector<Exponents> list = exponents(degree);
  const auto n = static_cast<Eigen::Index>(list.size());
  GradientProducts g{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
  const double per_area = 1 / (frame.size * frame.size);
  for (Eigen::Index a = 0; a < n; ++a) {
    for (Eigen::Index b = 0; b < n; ++b) {
      const Exponents p = list[static_cast<std::size_t>(a)];
      const Exponents q = list[static_cast<std::size_t>(b)];
      const auto moment = [&](int less_x, int less_y) {
        return per_area * moments(monomial(p.x + q.x - less_x, p.y + q.y - less_y));
      };
      if (p.x > 0 && q.x > 0) g.xx(a, b) = p.x * q.x * moment(2, 0);
      if (p.x > 0 && q.y > 0) g.xy(a, b) = p.x * q.y * moment(1, 1);
      if (p.y > 0 && q.y > 0) g.yy(a, b) = p.y * q.y * moment(0, 2);
    }
  }
  return g;
}

/// Returns ∫ Bᵀ D B from the products of the functions' gradients.
Eigen::MatrixXd stiffness_of(const GradientProducts& products, const Eigen::Matrix3d& modulus) {
  const auto& [xx, xy, yy] = products;
  const double d11 = modulus(0, 0);
  const double d12 = modulus(0, 1);
  const double d22 = modulus(1, 1);
  const double d33 = modulus(2, 2);
  const Eigen::Index n = xx.cols();
  Eigen::MatrixXd stiffness(2 * n, 2 * n);
  for (Eigen::Index a = 0; a < n; ++a) {
    for (Eigen::Index b = 0; b < n; ++b) {
      stiffness(2 * a, 2 * b) = d11 * xx(a, b) + d33 * yy(a, b);
      stiffness(2 * a, 2 * b + 1) = d12 * xy(a, b) + d33 * xy(b, a);
      stiffness(2 * a + 1, 2 * b) = d12 * xy(b, a) + d33 * xy(a, b);
      stiffness(2 * a + 1, 2 * b + 1) = d22 * yy(a, b) + d33 * xx(a, b);
    }
  }
  return stiffness;
}

/// Returns the products summed over points, for near-tip functions and for pieces too small for moments.
GradientProducts products_at_points(const Manifold& manifold, int element, const ElementShape& shape) {
  const Eigen::Index n = shape.function_count();
  GradientProducts sum{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
  for (const AreaPoint& p : area_rule(manifold, element, shape, 2 * (shape.degree - 1))) {
    const Eigen::Matrix2Xd g = shape.gradients(p.at);
    sum.xx += p.weight * g.row(0).transpose() * g.row(0);
    sum.xy += p.weight * g.row(0).transpose() * g.row(1);
    sum.yy += p.weight * g.row(1).transpose() * g.row(1);
  }
  return sum;
}

}  // namespace

Eigen::MatrixXd cover_stiffness(const ElementShape& shape, const Eigen::VectorXd& moments,
                                const Eigen::Matrix3d& modulus) {
  const GradientProducts of_monomials = gradient_products(shape.degree, shape.frame, moments);
  const auto& c = shape.monomial;
  return stiffness_of(
      {c.transpose() * of_monomials.xx * c, c.transpose() * of_monomials.xy * c, c.transpose() * of_monomials.yy * c},
      modulus);
}

void add_cover_stiffness(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system) {
  for (int e = 0; e < basis.element_count(); ++e) {
    const ElementShape shape = basis.shape(e);
    if (shape.tip != nullptr || is_small_piece(continuum.manifold, e)) {
      const GradientProducts products = products_at_points(continuum.manifold, e, shape);
      system.add_matrix(shape.functions, stiffness_of(products, continuum.modulus(e)));
      continue;
    }
    const auto loops = continuum.manifold.polygon(continuum.manifold.elements[static_cast<std::size_t>(e)]);
    const Eigen::VectorXd moments = polygon_moments(loops, shape.frame, 2 * (shape.degree - 1));
    system.add_matrix(shape.functions, cover_stiffness(shape, moments, continuum.modulus(e)));
  }
}

}  // namespace keyblock
