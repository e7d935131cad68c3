// Multiplies weights by cover functions; see cover_basis.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cover_basis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "model/derived_gradients.hpp"
#include "model/tips/tip_enrichment.hpp"

namespace keyblock {
namespace {

int order_of(CoverFunctions functions) {
  switch (functions) {
    case CoverFunctions::constant:
      return 0;
    case CoverFunctions::derived:
    case CoverFunctions::linear:
      return 1;
    case CoverFunctions::quadratic:
      return 2;
  }
  return 0;
}

/// Returns the frame at the middle of the triangle; its size is the side of an equilateral triangle of equal area.
LocalFrame frame_of(const std::array<Point, 3>& t) {
  const double area = cross(t[1] - t[0], t[2] - t[0]) / 2;
  return {(1.0 / 3) * (t[0] + t[1] + t[2]), std::sqrt(4 / std::sqrt(3.0) * area)};
}

/// Returns λ_k of a triangle in local coordinates.
std::array<Eigen::Vector3d, 3> weights_of(const std::array<Point, 3>& triangle, const LocalFrame& frame) {
  std::array<Point, 3> t;
  for (std::size_t k = 0; k < 3; ++k) t[k] = frame.local(triangle[k]);
  const double twice_area = cross(t[1] - t[0], t[2] - t[0]);
  std::array<Eigen::Vector3d, 3> weights;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point side = t[(k + 2) % 3] - t[(k + 1) % 3];
    weights[k] = Eigen::Vector3d(1.0 / 3, -side.y / twice_area, side.x / twice_area);
  }
  return weights;
}

/// Returns the local coordinate x or y minus that of a point, as a polynomial.
Eigen::Vector3d less_x(Point p) {
  return {-p.x, 1, 0};
}
Eigen::Vector3d less_y(Point p) {
  return {-p.y, 0, 1};
}

/// Returns the product of two polynomials of degree 1, without heap memory.
Eigen::Vector<double, 6> product_of_linear(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  constexpr std::array<std::array<Eigen::Index, 3>, 3> kPlace{{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
  Eigen::Vector<double, 6> result = Eigen::Vector<double, 6>::Zero();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result(kPlace[i][j]) += a(static_cast<Eigen::Index>(i)) * b(static_cast<Eigen::Index>(j));
  return result;
}

/// Returns one triangle side per cover, that of one of its elements.
std::vector<double> sizes_of_covers(const Manifold& manifold, const std::vector<LocalFrame>& frames) {
  std::vector<double> sizes(manifold.covers.size(), 1);
  for (std::size_t e = 0; e < manifold.elements.size(); ++e) {
    for (const int c : manifold.elements[e].covers) sizes[static_cast<std::size_t>(c)] = frames[e].size;
  }
  return sizes;
}

/// Returns the functions, ascending, of covers with derived gradients; those with an `own_gradient` derive none.
std::vector<int> functions_of_derived(const std::array<int, 3>& covers, const std::vector<int>& own_gradient,
                                      const std::vector<CoverGradient>& gradients) {
  std::vector<int> functions(covers.begin(), covers.end());
  for (const int cover : covers) {
    const auto c = static_cast<std::size_t>(cover);
    if (own_gradient[c] >= 0)
      functions.insert(functions.end(), {own_gradient[c], own_gradient[c] + 1});
    else
      for (const CoverGradient::Share& share : gradients[c].shares) functions.push_back(share.cover);
  }
  std::sort(functions.begin(), functions.end());
  functions.erase(std::unique(functions.begin(), functions.end()), functions.end());
  return functions;
}

/// A cover must not derive its gradient from covers with functions besides their polynomial.
void give_own_gradients(TipEnrichment& tips, const std::vector<CoverGradient>& gradients) {
  for (std::size_t c = 0; c < gradients.size(); ++c)
    for (const CoverGradient::Share& share : gradients[c].shares)
      if (tips.carries_functions(share.cover)) tips.give_own_gradient(static_cast<int>(c));
}

}  // namespace

const char* name_of(CoverFunctions functions) {
  switch (functions) {
    case CoverFunctions::constant:
      return "constant";
    case CoverFunctions::derived:
      return "derived";
    case CoverFunctions::linear:
      return "linear";
    case CoverFunctions::quadratic:
      return "quadratic";
  }
  return "";
}

// Eigen's general product packs its factors first, which costs more than products as small as these.
Eigen::RowVectorXd ElementShape::values(Point x) const {
  Eigen::RowVectorXd n = monomials(degree, frame.local(x)).transpose().lazyProduct(monomial);
  if (tip != nullptr) tip->add_values(x, n);
  return n;
}

Eigen::Matrix2Xd ElementShape::gradients(Point x) const {
  Eigen::Matrix2Xd g = monomial_gradients(degree, frame.local(x)).transpose().lazyProduct(monomial) / frame.size;
  if (tip != nullptr) tip->add_gradients(x, g);
  return g;
}

Eigen::Matrix2Xd ElementShape::displacement(Point x) const {
  const Eigen::RowVectorXd n = values(x);
  Eigen::Matrix2Xd t = Eigen::Matrix2Xd::Zero(2, 2 * n.size());
  for (Eigen::Index a = 0; a < n.size(); ++a) t(0, 2 * a) = t(1, 2 * a + 1) = n(a);
  return t;
}

Eigen::Matrix3Xd ElementShape::strain(Point x) const {
  const Eigen::Matrix2Xd g = gradients(x);
  Eigen::Matrix3Xd b = Eigen::Matrix3Xd::Zero(3, 2 * g.cols());
  for (Eigen::Index a = 0; a < g.cols(); ++a) {
    b(0, 2 * a) = b(2, 2 * a + 1) = g(0, a);
    b(1, 2 * a + 1) = b(2, 2 * a) = g(1, a);
  }
  return b;
}

CoverBasis::CoverBasis(const Manifold& manifold, CoverFunctions functions, const TipFunctionPlan& plan)
    : functions_(functions), degree_(order_of(functions) + 1) {
  frames_.reserve(manifold.elements.size());
  first_number_.reserve(manifold.elements.size() + 1);
  for (const ManifoldElement& element : manifold.elements) frames_.push_back(frame_of(manifold.triangle(element)));
  std::unique_ptr<TipEnrichment> tips;
  if (plan.are_asked() && !manifold.tips.empty()) tips = std::make_unique<TipEnrichment>(manifold, plan);
  if (functions == CoverFunctions::derived) {
    function_count_ = static_cast<int>(manifold.covers.size());
    add_derived(manifold, tips.get());
  } else {
    function_count_ = static_cast<int>(manifold.covers.size()) * monomial_count(degree_ - 1);
    if (tips) function_count_ = tips->number_functions(function_count_);
    add_cover_polynomials(manifold, tips.get());
  }
  first_number_.push_back(numbers_.size());
}

ElementShape CoverBasis::shape(int element) const {
  const auto e = static_cast<std::size_t>(element);
  const std::size_t first = first_number_[e];
  const std::size_t count = first_number_[e + 1] - first;
  const int rows = monomial_count(degree_);
  return {degree_, std::span(numbers_).subspan(first, count),
          Eigen::Map<const Eigen::MatrixXd>(coefficients_.data() + first * static_cast<std::size_t>(rows), rows,
                                            static_cast<Eigen::Index>(count)),
          frames_[e],
          tip_shape_of_.empty() || tip_shape_of_[e] < 0 ? nullptr
                                                        : &tip_shapes_[static_cast<std::size_t>(tip_shape_of_[e])]};
}

CoverFunctions CoverBasis::functions(int element) const {
  return !is_linear_.empty() && is_linear_[static_cast<std::size_t>(element)] != 0 ? CoverFunctions::linear
                                                                                   : functions_;
}

// Near-tip functions follow the polynomials and have no monomials.
void CoverBasis::add(std::vector<int> functions, const Eigen::MatrixXd& monomial, const TipEnrichment* tips) {
  const auto element = static_cast<int>(first_number_.size());
  if (element == 0) {  // most have as many as the first, or one more
    numbers_.reserve(frames_.size() * (functions.size() + 1));
    coefficients_.reserve(numbers_.capacity() * static_cast<std::size_t>(monomial.rows()));
  }
  const std::size_t polynomials = functions.size();
  if (tips != nullptr) {
    TipShape shape = tips->shape(element, functions);
    shape.first = static_cast<int>(polynomials);
    tip_shape_of_.push_back(shape.functions.empty() ? -1 : static_cast<int>(tip_shapes_.size()));
    if (!shape.functions.empty()) tip_shapes_.push_back(std::move(shape));
  }
  first_number_.push_back(numbers_.size());
  numbers_.insert(numbers_.end(), functions.begin(), functions.end());
  coefficients_.insert(coefficients_.end(), monomial.data(), monomial.data() + monomial.size());
  coefficients_.resize(coefficients_.size() +
                       (functions.size() - polynomials) * static_cast<std::size_t>(monomial.rows()));
}

// Function m of cover i has number i·count + m: λ_i times the m-th monomial of (x - x_i) in sides of the triangle. The
// side is that of the cover, because the sides of its elements agree only in a regular mesh.
void CoverBasis::add_cover_polynomials(const Manifold& manifold, const TipEnrichment* tips) {
  const int count = monomial_count(degree_ - 1);
  const std::vector<double> sizes = sizes_of_covers(manifold, frames_);
  for (std::size_t e = 0; e < manifold.elements.size(); ++e) {
    const std::array<int, 3>& covers = manifold.elements[e].covers;
    const std::array<Point, 3> triangle = manifold.triangle(manifold.elements[e]);
    const std::array<Eigen::Vector3d, 3> weights = weights_of(triangle, frames_[e]);
    std::vector<int> functions;
    Eigen::MatrixXd monomial(monomial_count(degree_), 3 * count);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point node = frames_[e].local(triangle[k]);
      const double scale = frames_[e].size / sizes[static_cast<std::size_t>(covers[k])];
      for (const Exponents& power : exponents(degree_ - 1)) {
        Eigen::VectorXd of_cover = Eigen::VectorXd::Ones(1);
        int degree = 0;
        for (int i = 0; i < power.x; ++i) of_cover = product(of_cover, degree++, scale * less_x(node), 1);
        for (int j = 0; j < power.y; ++j) of_cover = product(of_cover, degree++, scale * less_y(node), 1);
        const Eigen::VectorXd function = product(weights[k], 1, of_cover, degree);
        auto column = monomial.col(static_cast<Eigen::Index>(functions.size()));
        column.setZero();
        column.head(function.size()) = function;
        functions.push_back(covers[k] * count + monomial_place(power));
      }
    }
    add(std::move(functions), monomial, tips);
  }
}

void CoverBasis::add_derived(const Manifold& manifold, TipEnrichment* tips) {
  const std::vector<CoverGradient> gradients = derived_gradients(manifold);
  std::vector<int> own_gradient(manifold.covers.size(), -1);  // its first function, by x; the next is by y
  std::vector<double> sizes;
  if (tips != nullptr) {
    give_own_gradients(*tips, gradients);
    sizes = sizes_of_covers(manifold, frames_);
    for (std::size_t c = 0; c < own_gradient.size(); ++c)
      if (tips->has_own_gradient(static_cast<int>(c)))
        own_gradient[c] = std::exchange(function_count_, function_count_ + 2);
    function_count_ = tips->number_functions(function_count_);
    for (const ManifoldElement& element : manifold.elements)
      is_linear_.push_back(std::ranges::any_of(element.covers, [&](int c) { return tips->has_own_gradient(c); }) ? 1
                                                                                                                 : 0);
  }
  Eigen::VectorXd per_x, per_y;
  for (std::size_t e = 0; e < manifold.elements.size(); ++e) {
    const std::array<int, 3>& covers = manifold.elements[e].covers;
    const std::array<Point, 3> triangle = manifold.triangle(manifold.elements[e]);
    const std::array<Eigen::Vector3d, 3> weights = weights_of(triangle, frames_[e]);
    std::vector<int> functions = functions_of_derived(covers, own_gradient, gradients);
    Eigen::MatrixXd monomial = Eigen::MatrixXd::Zero(monomial_count(2), static_cast<Eigen::Index>(functions.size()));
    const auto of = [&](int function) {
      return monomial.col(std::lower_bound(functions.begin(), functions.end(), function) - functions.begin());
    };
    for (std::size_t k = 0; k < 3; ++k) {
      of(covers[k]).head(3) += weights[k];
      const Point node = frames_[e].local(triangle[k]);
      const auto c = static_cast<std::size_t>(covers[k]);
      if (own_gradient[c] >= 0) {
        const double scale = frames_[e].size / sizes[c];
        of(own_gradient[c]) += scale * product_of_linear(weights[k], less_x(node));
        of(own_gradient[c] + 1) += scale * product_of_linear(weights[k], less_y(node));
        continue;
      }
      const double half = frames_[e].size / 2;
      per_x = half * product_of_linear(weights[k], less_x(node));
      per_y = half * product_of_linear(weights[k], less_y(node));
      for (const CoverGradient::Share& share : gradients[c].shares)
        of(share.cover) += share.weight.x * per_x + share.weight.y * per_y;
    }
    add(std::move(functions), monomial, tips);
  }
}

}  // namespace keyblock
