// Samples of the stress, a fit for each cover, and the difference; see stress_error.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/mesh/stress_error.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/polynomial.hpp"

namespace keyblock {
namespace {

// Fits to fewer say little: those at the rim of a body look one ring of elements further.
constexpr std::size_t kFewElements = 4;
// Of the largest column: what samples in so few elements do not tell stays at the least values that fit.
constexpr double kTold = 1e-6;

/// The stress at a point of an element, and the share of area that it stands for.
struct Sample {
  Point at;
  double weight = 0;
  Eigen::Vector3d stress;
};

/// A polynomial for each component.
struct Fit {
  LocalFrame frame;
  Eigen::MatrixX3d coefficients;  ///< monomials × components

  Eigen::Vector3d at(int degree, Point x) const { return coefficients.transpose() * monomials(degree, frame.local(x)); }
};

/// The weights of a triangle's corners at x.
std::array<double, 3> weights_at(const std::array<Point, 3>& t, Point x) {
  const double whole = cross(t[1] - t[0], t[2] - t[0]);
  return {cross(t[1] - x, t[2] - x) / whole, cross(t[2] - x, t[0] - x) / whole, cross(t[0] - x, t[1] - x) / whole};
}

class Recovery {
 public:
  Recovery(const Continuum& continuum, const CoverBasis& basis, const Eigen::VectorXd& d)
      : continuum_(continuum), manifold_(continuum.manifold), basis_(basis), d_(d), degree_(basis.degree()) {
    samples_.resize(manifold_.elements.size());
    for (std::size_t e = 0; e < samples_.size(); ++e) samples_[e] = samples_in(static_cast<int>(e), 2 * degree_ - 2);
    for (std::size_t c = 0; c < manifold_.covers.size(); ++c) fits_.push_back(fit_of(static_cast<int>(c)));
  }

  StressError error() const {
    StressError error;
    error.of_element.assign(manifold_.elements.size(), 0);
    for (std::size_t e = 0; e < manifold_.elements.size(); ++e) {
      const bool is_polynomial = basis_.shape(static_cast<int>(e)).tip == nullptr;
      const Eigen::Matrix3d compliance = continuum_.modulus(static_cast<int>(e)).inverse();
      for (const Sample& s : samples_in(static_cast<int>(e), 2 * degree_)) {
        error.strain += s.weight * s.stress.dot(compliance * s.stress);
        if (!is_polynomial) continue;
        const Eigen::Vector3d off = recovered(static_cast<int>(e), s.at) - s.stress;
        error.of_element[e] += s.weight * off.dot(compliance * off);
      }
      // The points of an area with re-entrant corners may count some of it negative.
      error.of_element[e] = std::max(0.0, error.of_element[e]);
      error.total += error.of_element[e];
    }
    return error;
  }

 private:
  std::vector<Sample> samples_in(int e, int degree) const {
    const ElementShape shape = basis_.shape(e);
    const Eigen::Matrix3d modulus = continuum_.modulus(e);
    Eigen::VectorXd own(2 * shape.function_count());
    for (int a = 0; a < shape.function_count(); ++a)
      own.segment<2>(2 * a) = d_.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]);
    std::vector<Sample> samples;
    for (const AreaPoint& p : area_rule(manifold_, e, shape, degree))
      samples.push_back({p.at, p.weight, modulus * (shape.strain(p.at) * own)});
    return samples;
  }

  /// The elements of a cover, and where they are few those of all covers about.
  std::vector<int> elements_about(int cover) const {
    const auto own = manifold_.elements_of(manifold_.covers[static_cast<std::size_t>(cover)]);
    std::vector<int> elements(own.begin(), own.end());
    if (elements.size() >= kFewElements) return elements;
    for (const int e : own)
      for (const int other : manifold_.elements[static_cast<std::size_t>(e)].covers)
        for (const int more : manifold_.elements_of(manifold_.covers[static_cast<std::size_t>(other)]))
          elements.push_back(more);
    std::ranges::sort(elements);
    const auto repeated = std::ranges::unique(elements);
    elements.erase(repeated.begin(), repeated.end());
    return elements;
  }

  Fit fit_of(int cover) const {
    const std::vector<int> elements = elements_about(cover);
    Fit fit;
    const int node = manifold_.covers[static_cast<std::size_t>(cover)].node;
    fit.frame = {manifold_.mesh.nodes[static_cast<std::size_t>(node)], 0};
    Eigen::Index rows = 0;
    for (const int e : elements)
      for (const Sample& s : samples_[static_cast<std::size_t>(e)]) {
        fit.frame.size = std::max(fit.frame.size, distance(s.at, fit.frame.origin));
        ++rows;
      }
    Eigen::MatrixXd left(rows, monomial_count(degree_));
    Eigen::MatrixX3d right(rows, 3);
    Eigen::Index row = 0;
    for (const int e : elements)
      for (const Sample& s : samples_[static_cast<std::size_t>(e)]) {
        const double weight = std::sqrt(std::abs(s.weight));
        left.row(row) = weight * monomials(degree_, fit.frame.local(s.at)).transpose();
        right.row(row++) = weight * s.stress.transpose();
      }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
    factors.setThreshold(kTold);
    fit.coefficients = factors.compute(left).solve(right);
    return fit;
  }

  Eigen::Vector3d recovered(int e, Point x) const {
    const ManifoldElement& element = manifold_.elements[static_cast<std::size_t>(e)];
    const std::array<double, 3> weights = weights_at(manifold_.triangle(element), x);
    Eigen::Vector3d stress = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      stress += weights[k] * fits_[static_cast<std::size_t>(element.covers[k])].at(degree_, x);
    return stress;
  }

  const Continuum& continuum_;
  const Manifold& manifold_;
  const CoverBasis& basis_;
  const Eigen::VectorXd& d_;
  int degree_;
  std::vector<std::vector<Sample>> samples_;  // of each element, those that are fitted
  std::vector<Fit> fits_;                     // of each cover
};

}  // namespace

double StressError::share() const {
  return total > 0 ? std::sqrt(total / (strain + total)) : 0;
}

StressError stress_error(const Continuum& continuum, const CoverBasis& basis, const Eigen::VectorXd& d) {
  return Recovery(continuum, basis, d).error();
}

}  // namespace keyblock
