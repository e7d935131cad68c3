// Samples the stress, fits a polynomial per cover, and integrates the difference; see stress_error.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/mesh/stress_error.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/polygon.hpp"
#include "geometry/polynomial.hpp"

namespace keyblock {
namespace {

// Least number of stress values per coefficient of a fit. A fit with as many coefficients as values would be exact for
// any values.
constexpr int kMoreThanFitted = 2;
constexpr double kWhole = 1e-6;  // of a triangle that no line cuts, by round-off
constexpr int kMostRings = 3;    // rings of elements around a cover used by its fit
// Strain by round-off alone, relative to displacement over element size and to initial stress over Young's modulus.
// Solutions have about ten correct digits.
constexpr double kRoundOff = 1e-10;
// Threshold relative to the largest column. Coefficients that the samples do not determine take the least values that
// fit.
constexpr double kTold = 1e-6;

/// Stress at a point of an element, with its share of the area.
struct Sample {
  Point at;
  double weight = 0;
  Eigen::Vector3d stress;
  double displacement = 0;
};

double square(double v) {
  return v * v;
}

/// One polynomial per component.
struct Fit {
  LocalFrame frame;
  Eigen::MatrixX3d coefficients;  ///< monomials × components
  bool is_told = false;           ///< determined by more stress values than coefficients

  Eigen::Vector3d at(int degree, Point x) const { return coefficients.transpose() * monomials(degree, frame.local(x)); }
};

/// Returns the weights of a triangle's corners at x.
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
    has_whole_triangle_.assign(manifold_.body_materials.size(), 0);
    for (const ManifoldElement& element : manifold_.elements)
      if (is_whole(element)) has_whole_triangle_[static_cast<std::size_t>(element.body)] = 1;
  }

  StressError error(std::span<const Uncounted> uncounted) const {
    StressError error;
    error.of_element.assign(manifold_.elements.size(), 0);
    for (std::size_t e = 0; e < manifold_.elements.size(); ++e) {
      const bool is_polynomial = basis_.shape(static_cast<int>(e)).tip == nullptr;
      const Eigen::Matrix3d compliance = continuum_.modulus(static_cast<int>(e)).inverse();
      for (const Sample& s : samples_in(static_cast<int>(e), 2 * degree_)) {
        const auto holds = [&](const Uncounted& disc) { return distance(disc.at, s.at) < disc.radius; };
        if (std::ranges::any_of(uncounted, holds)) continue;
        error.strain += s.weight * s.stress.dot(compliance * s.stress);
        error.round_off += s.weight * round_off_at(static_cast<int>(e), s);
        if (!is_polynomial) continue;
        const Eigen::Vector3d off =
            is_told(static_cast<int>(e)) ? Eigen::Vector3d(recovered(static_cast<int>(e), s.at) - s.stress) : s.stress;
        error.of_element[e] += s.weight * off.dot(compliance * off);
      }
      // The quadrature of an area with re-entrant corners may have negative weights.
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
      samples.push_back(
          {p.at, p.weight, modulus * (shape.strain(p.at) * own), (shape.displacement(p.at) * own).norm()});
    return samples;
  }

  /// Returns σ:ε by round-off alone at a sample of element e.
  double round_off_at(int e, const Sample& s) const {
    const std::array<Point, 3> t = manifold_.triangle(manifold_.elements[static_cast<std::size_t>(e)]);
    const double size = std::sqrt(std::abs(cross(t[1] - t[0], t[2] - t[0])));
    const double youngs_modulus = continuum_.material(e).youngs_modulus;
    const Stress initial = continuum_.initial_stress_at(e, s.at);
    const double stress = std::hypot(initial.xx, initial.yy, initial.xy);
    return youngs_modulus * square(kRoundOff * (s.displacement / size + stress / youngs_modulus));
  }

  bool are_enough(const std::vector<int>& elements) const {
    return std::ssize(elements) * monomial_count(degree_ - 1) >= kMoreThanFitted * monomial_count(degree_);
  }

  bool is_whole(const ManifoldElement& element) const {
    const std::array<Point, 3> t = manifold_.triangle(element);
    double area = 0;
    for (const std::vector<Point>& loop : manifold_.polygon(element)) area += keyblock::area(loop);
    return area >= (1 - kWhole) * std::abs(cross(t[1] - t[0], t[2] - t[0])) / 2;
  }

  /// Returns true if the fits of an element's covers determine its stress. If all triangles are wider than the body,
  /// displacements are nearly those of one triangle, and so are stresses.
  bool is_told(int e) const {
    const ManifoldElement& element = manifold_.elements[static_cast<std::size_t>(e)];
    return has_whole_triangle_[static_cast<std::size_t>(element.body)] != 0 &&
           std::ranges::all_of(element.covers,
                               [&](int cover) { return fits_[static_cast<std::size_t>(cover)].is_told; });
  }

  /// Returns the elements of a cover, and ring by ring those of all neighbouring covers, until their stresses suffice.
  std::vector<int> elements_about(int cover) const {
    const auto own = manifold_.elements_of(manifold_.covers[static_cast<std::size_t>(cover)]);
    std::vector<int> elements(own.begin(), own.end());
    for (int ring = 0; ring < kMostRings && !are_enough(elements); ++ring) {
      const std::vector<int> inner = elements;
      for (const int e : inner)
        for (const int other : manifold_.elements[static_cast<std::size_t>(e)].covers)
          for (const int more : manifold_.elements_of(manifold_.covers[static_cast<std::size_t>(other)]))
            elements.push_back(more);
      std::ranges::sort(elements);
      const auto repeated = std::ranges::unique(elements);
      elements.erase(repeated.begin(), repeated.end());
    }
    return elements;
  }

  Fit fit_of(int cover) const {
    const std::vector<int> elements = elements_about(cover);
    Fit fit;
    fit.is_told = are_enough(elements);
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
  std::vector<std::vector<Sample>> samples_;  // of each element, used for the fits
  std::vector<Fit> fits_;                     // per cover
  std::vector<char> has_whole_triangle_;      // per body
};

}  // namespace

double StressError::share() const {
  return strain > round_off ? std::sqrt(total / (strain + total)) : 0;
}

StressError stress_error(const Continuum& continuum, const CoverBasis& basis, const Eigen::VectorXd& d,
                         std::span<const Uncounted> uncounted) {
  return Recovery(continuum, basis, d).error(uncounted);
}

}  // namespace keyblock
