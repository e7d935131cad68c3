// Integrates point by point, with the points of an element stacked into one matrix product; see cover_elasticity.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_elasticity.hpp"

#include <Eigen/LU>
#include <utility>

#include "geometry/quadrature.hpp"
#include "material/material_stress.hpp"
#include "terms/cover_inertia.hpp"
#include "terms/green_strain.hpp"

namespace keyblock {
namespace {

/// Returns points exact for the energy: E is of degree 2 (degree - 1). First-order functions need one, at the centroid,
/// where a stress linear in y has its mean. The centroid of a small piece is lost in the round-off of moments about the
/// middle of the triangle; there a sum over points has the same mean.
std::vector<AreaPoint> points_of(const Manifold& manifold, int element, const ElementShape& shape) {
  const auto loops = manifold.polygon(manifold.elements[static_cast<std::size_t>(element)]);
  if (shape.degree > 1) return polygon_rule(loops, 4 * (shape.degree - 1));
  if (is_small_piece(manifold, element)) return polygon_rule(loops, 1);
  const Eigen::VectorXd moments = polygon_moments(loops, shape.frame, 1);
  const double size = shape.frame.size / moments(0);
  return {{shape.frame.origin + Point{size * moments(1), size * moments(2)}, moments(0)}};
}

/// Returns (dx, dy) of function a of the element in row a.
Eigen::MatrixX2d unknowns_of(const ElementShape& shape, const Eigen::VectorXd& d) {
  Eigen::MatrixX2d own(shape.function_count(), 2);
  for (int a = 0; a < shape.function_count(); ++a)
    own.row(a) = d.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]).transpose();
  return own;
}

/// Sets `h` to H = Σ ∇N_a d_a of each point, transposed, one below the other. Plain sums: the matrices are too small
/// for blocked products, and `h` keeps its memory from one element to the next.
void displacement_gradients(const Eigen::MatrixXd& gradients, std::span<const int> functions, const Eigen::VectorXd& d,
                            Eigen::MatrixX2d& h) {
  h.setZero(gradients.rows(), 2);
  for (Eigen::Index a = 0; a < gradients.cols(); ++a) {
    const double* const own = d.data() + 2 * functions[static_cast<std::size_t>(a)];
    for (Eigen::Index i = 0; i < h.rows(); ++i) {
      h(i, 0) += gradients(i, a) * own[0];
      h(i, 1) += gradients(i, a) * own[1];
    }
  }
}

/// Adds ∇Nᵀ `flux` to `force`, by functions.
void add_flux(const Eigen::MatrixXd& gradients, std::span<const int> functions, const Eigen::MatrixX2d& flux,
              Eigen::VectorXd& force) {
  for (Eigen::Index a = 0; a < gradients.cols(); ++a) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (Eigen::Index i = 0; i < flux.rows(); ++i) sum += gradients(i, a) * flux.row(i).transpose();
    force.segment<2>(2 * functions[static_cast<std::size_t>(a)]) += sum;
  }
}

/// Returns the 2 × 2 matrix of a point stacked by displacement_gradients.
Eigen::Matrix2d at_point(const Eigen::MatrixX2d& stacked, Eigen::Index point) {
  return stacked.middleRows<2>(2 * point).transpose();
}

double weight_of(int element, double common, std::span<const double> more) {
  return more.empty() ? common : common + more[static_cast<std::size_t>(element)];
}

}  // namespace

CoverElasticity::CoverElasticity(const Continuum& continuum, CoverBasis basis)
    : basis_(std::move(basis)),
      more_(continuum.initial_stress),
      gives_zz_(continuum.gives_initial_zz && continuum.plane == Plane::strain) {
  for (int e = 0; e < basis_.element_count(); ++e) {
    const BlockMaterial& material = continuum.material(e);
    initial_.push_back(start_stress(material, material.stress_gradient, 0, continuum.plane));
    gradient_.push_back(material.stress_gradient);
    gradient_.back().zz = start_stress(material, material.stress_gradient, 1, continuum.plane).zz - initial_.back().zz;
    share_across_.push_back(share_across(material, continuum.plane));
    const ElementShape shape = basis_.shape(e);
    const bool yields = material.is_nonlinear();  // left to CoverYield
    const std::vector<AreaPoint> points = yields ? std::vector<AreaPoint>() : points_of(continuum.manifold, e, shape);
    const auto count = static_cast<Eigen::Index>(points.size());
    Element& element = elements_.emplace_back();
    element.modulus = continuum.modulus(e);
    element.law = continuum.law(e);
    element.gradients.resize(2 * count, shape.function_count());
    element.weights.resize(count);
    element.initial.resize(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const AreaPoint& point = points[static_cast<std::size_t>(i)];
      element.gradients.middleRows<2>(2 * i) = shape.gradients(point.at);
      element.weights(i) = point.weight;
      element.initial.col(i) = in_plane(initial_stress(e, point.at));
    }
  }
}

double CoverElasticity::energy(const Eigen::VectorXd& d) const {
  double sum = 0;
  Eigen::MatrixX2d h;
  for (int e = 0; e < basis_.element_count(); ++e) {
    const Element& element = elements_[static_cast<std::size_t>(e)];
    displacement_gradients(element.gradients, basis_.shape(e).functions, d, h);
    for (Eigen::Index i = 0; i < element.weights.size(); ++i)
      sum += element.weights(i) * element.at(i).energy(green_strain(at_point(h, i)));
  }
  return sum;
}

Eigen::VectorXd CoverElasticity::force(const Eigen::VectorXd& d0, const Eigen::VectorXd& d1, double common,
                                       std::span<const double> more) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(d0.size());
  Eigen::MatrixX2d h0, h1, flux;  // flux: S F_halfᵀ
  for (int e = 0; e < basis_.element_count(); ++e) {
    const Element& element = elements_[static_cast<std::size_t>(e)];
    const std::span<const int> functions = basis_.shape(e).functions;
    displacement_gradients(element.gradients, functions, d0, h0);
    displacement_gradients(element.gradients, functions, d1, h1);
    const double theta = weight_of(e, common, more);
    flux.resize(h0.rows(), 2);
    for (Eigen::Index i = 0; i < element.weights.size(); ++i) {
      const Eigen::Matrix2d start = at_point(h0, i);
      const Eigen::Matrix2d end = at_point(h1, i);
      const Eigen::Matrix2d stress =
          stress_tensor(element.at(i).stress_of_step(green_strain(start), green_strain(end), theta));
      const Eigen::Matrix2d mean = Eigen::Matrix2d::Identity() + (start + end) / 2;
      flux.middleRows<2>(2 * i) = element.weights(i) * stress * mean.transpose();
    }
    add_flux(element.gradients, functions, flux, force);
  }
  return force;
}

void CoverElasticity::add_tangent(const Eigen::VectorXd& d0, const Eigen::VectorXd& d1, double common,
                                  std::span<const double> more, double scale, SparseSystem& system) const {
  Linearised points;
  Eigen::MatrixX2d h0, h1;
  for (int e = 0; e < basis_.element_count(); ++e) {
    const Element& element = elements_[static_cast<std::size_t>(e)];
    const double theta = weight_of(e, common, more);
    const std::span<const int> functions = basis_.shape(e).functions;
    displacement_gradients(element.gradients, functions, d0, h0);
    displacement_gradients(element.gradients, functions, d1, h1);
    points.stress.resize(3, element.weights.size());
    points.stiffness.clear();
    for (Eigen::Index i = 0; i < element.weights.size(); ++i) {
      const Eigen::Vector3d from = green_strain(at_point(h0, i));
      const Eigen::Vector3d to = green_strain(at_point(h1, i));
      points.stress.col(i) = element.at(i).stress_of_step(from, to, theta);
      points.stiffness.push_back(element.at(i).stiffness_of_step(from, to, theta));
    }
    h0 = (h0 + h1) / 2;
    add_element_tangent(e, h0, theta * scale, scale / 2, points, system);
  }
}

void CoverElasticity::add_static_tangent(const Eigen::VectorXd& d, double scale, SparseSystem& system) const {
  Linearised points;
  Eigen::MatrixX2d h;
  for (int e = 0; e < basis_.element_count(); ++e) {
    const Element& element = elements_[static_cast<std::size_t>(e)];
    displacement_gradients(element.gradients, basis_.shape(e).functions, d, h);
    points.stress.resize(3, element.weights.size());
    points.stiffness.clear();
    for (Eigen::Index i = 0; i < element.weights.size(); ++i) {
      const Eigen::Vector3d strain = green_strain(at_point(h, i));
      points.stress.col(i) = element.at(i).stress(strain);
      points.stiffness.push_back(element.at(i).stiffness(strain));
    }
    add_element_tangent(e, h, scale, scale, points, system);
  }
}

// Bᵀ D B with three columns of Bᵀ per point, ∇N S ∇N with two.
void CoverElasticity::add_element_tangent(int e, const Eigen::MatrixX2d& mean, double material, double geometric,
                                          Linearised& points, SparseSystem& system) const {
  const Element& element = elements_[static_cast<std::size_t>(e)];
  const Eigen::Index count = element.weights.size();
  const Eigen::Index n = element.gradients.cols();
  auto& [stress, stiffness, b, weighted, stressed, tangent, both] = points;
  b.resize(2 * n, 3 * count);
  weighted.resize(3 * count, 2 * n);
  stressed.resize(2 * count, n);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Matrix2d f = Eigen::Matrix2d::Identity() + at_point(mean, i);
    const auto g = element.gradients.middleRows<2>(2 * i);
    const Eigen::Matrix3d of_point = material * element.weights(i) * stiffness[static_cast<std::size_t>(i)];
    const Eigen::Matrix2d geometry = geometric * element.weights(i) * stress_tensor(stress.col(i));
    for (Eigen::Index a = 0; a < n; ++a) {
      const Eigen::Vector2d ga = g.col(a);
      for (Eigen::Index k = 0; k < 2; ++k) {
        const Eigen::Vector3d column{f(k, 0) * ga(0), f(k, 1) * ga(1), f(k, 0) * ga(1) + f(k, 1) * ga(0)};
        b.block<1, 3>(2 * a + k, 3 * i) = column.transpose();
        weighted.block<3, 1>(3 * i, 2 * a + k) = of_point * column;
      }
      stressed.block<2, 1>(2 * i, a) = geometry * ga;
    }
  }
  // Blocked products cost more than they save for few points.
  constexpr Eigen::Index kFewPoints = 3;
  if (count <= kFewPoints) {
    tangent = b.lazyProduct(weighted);
    both = element.gradients.transpose().lazyProduct(stressed);
  } else {
    tangent = b * weighted;
    both = element.gradients.transpose() * stressed;
  }
  for (Eigen::Index a = 0; a < n; ++a)
    for (Eigen::Index c = 0; c < n; ++c) {
      tangent(2 * a, 2 * c) += both(a, c);
      tangent(2 * a + 1, 2 * c + 1) += both(a, c);
    }
  system.add_matrix(basis_.shape(e).functions, tangent);
}

Stress CoverElasticity::initial_stress(int e, Point x) const {
  const auto i = static_cast<std::size_t>(e);
  const Stress& at_zero = initial_[i];
  const Stress& per_y = gradient_[i];
  const Stress more = more_ ? more_(x) : Stress{};
  const double more_across = gives_zz_ ? more.zz : share_across_[i] * (more.xx + more.yy);
  return {at_zero.xx + x.y * per_y.xx + more.xx, at_zero.yy + x.y * per_y.yy + more.yy,
          at_zero.xy + x.y * per_y.xy + more.xy, at_zero.zz + x.y * per_y.zz + more_across};
}

Point CoverElasticity::position(const Eigen::VectorXd& d, int element, Point at_start) const {
  const ElementShape shape = basis_.shape(element);
  const Eigen::RowVector2d u = shape.values(at_start) * unknowns_of(shape, d);
  return at_start + Point{u.x(), u.y()};
}

Eigen::Matrix2d CoverElasticity::deformation(const Eigen::VectorXd& d, int element, Point at_start) const {
  const ElementShape shape = basis_.shape(element);
  return Eigen::Matrix2d::Identity() + (shape.gradients(at_start) * unknowns_of(shape, d)).transpose();
}

Stress CoverElasticity::stress_of(const Eigen::Matrix2d& f, int element, Point at_start) const {
  const Eigen::Vector3d green = green_strain(f - Eigen::Matrix2d::Identity());
  const Element& own = elements_[static_cast<std::size_t>(element)];
  const Stress start = initial_stress(element, at_start);
  const Eigen::Vector3d initial = in_plane(start);
  const ElasticPoint point{own.law, own.modulus, Eigen::Map<const Eigen::Vector3d>(initial.data())};
  const Eigen::Matrix2d cauchy = f * stress_tensor(point.stress(green)) * f.transpose() / f.determinant();
  // There is no strain across the plane under plane strain, and no stress under plane stress.
  const Stress measured =
      with_across(point.stress_of_measure(green), start, share_across_[static_cast<std::size_t>(element)]);
  return {cauchy(0, 0), cauchy(1, 1), cauchy(0, 1), measured.zz / f.determinant()};
}

}  // namespace keyblock
