// Integrates differences of extended polynomials; see ghost_penalty.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/ghost_penalty.hpp"

#include <algorithm>
#include <array>

#include "geometry/polygon.hpp"
#include "geometry/quadrature.hpp"
#include "terms/stabilisation.hpp"

namespace keyblock {
namespace {

// Share of its triangle below which a missing part of an element is ignored.
constexpr double kWhole = 1e-10;

bool is_cut(const Manifold& manifold, const ManifoldElement& element) {
  const std::array<Point, 3> triangle = manifold.triangle(element);
  double covered = 0;
  for (const std::vector<Point>& loop : manifold.polygon(element)) covered += area(loop);
  return covered < (1 - kWhole) * area(triangle);
}

std::vector<int> neighbours_of(const Manifold& manifold, const ManifoldElement& element) {
  std::vector<int> found;
  const auto add = [&](const SlotRange& loop) {
    for (const ElementCorner& corner : manifold.loop(loop)) {
      if (corner.neighbour >= 0) found.push_back(corner.neighbour);
    }
  };
  add(element.outer);
  for (const SlotRange& hole : manifold.holes_of(element)) add(hole);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Returns true if the element has near-tip functions and its triangle holds a tip, inside or on its edge. No
/// polynomial extends from there.
bool is_at_tip(const Manifold& manifold, const CoverBasis& basis, int element) {
  if (basis.shape(element).tip == nullptr) return false;
  const std::array<Point, 3> triangle = manifold.triangle(manifold.elements[static_cast<std::size_t>(element)]);
  return std::any_of(manifold.tips.begin(), manifold.tips.end(),
                     [&](const CrackTip& tip) { return side(triangle, tip.at) != Side::outside; });
}

}  // namespace

std::vector<GhostPair> ghost_pairs(const Manifold& manifold, const CoverBasis& basis) {
  std::vector<char> cut;
  for (const ManifoldElement& element : manifold.elements) cut.push_back(is_cut(manifold, element) ? 1 : 0);
  std::vector<GhostPair> pairs;
  for (int e = 0; e < basis.element_count(); ++e) {
    const ManifoldElement& element = manifold.elements[static_cast<std::size_t>(e)];
    for (const int other : neighbours_of(manifold, element)) {
      const bool is_counted = cut[static_cast<std::size_t>(e)] != 0 || cut[static_cast<std::size_t>(other)] != 0;
      const int beyond = manifold.elements[static_cast<std::size_t>(other)].triangle;
      if (other < e || !is_counted || beyond == element.triangle) continue;
      if (is_at_tip(manifold, basis, e) || is_at_tip(manifold, basis, other)) continue;
      std::vector<int> functions(basis.shape(e).functions.begin(), basis.shape(e).functions.end());
      const auto of_other = basis.shape(other).functions;
      functions.insert(functions.end(), of_other.begin(), of_other.end());
      std::sort(functions.begin(), functions.end());
      functions.erase(std::unique(functions.begin(), functions.end()), functions.end());
      pairs.push_back({e, other, std::move(functions)});
    }
  }
  return pairs;
}

std::vector<GhostPair> elastic_ghost_pairs(const Continuum& continuum, const CoverBasis& basis) {
  std::vector<GhostPair> pairs = ghost_pairs(continuum.manifold, basis);
  std::erase_if(pairs, [&](const GhostPair& pair) {
    return continuum.material(pair.first).is_nonlinear() || continuum.material(pair.second).is_nonlinear();
  });
  return pairs;
}

void add_ghost_penalty(const Continuum& continuum, const CoverBasis& basis, const std::vector<GhostPair>& pairs,
                       SparseSystem& system) {
  const Manifold& manifold = continuum.manifold;
  for (const GhostPair& pair : pairs) {
    const auto n = static_cast<Eigen::Index>(pair.functions.size());
    const ElementShape first = basis.shape(pair.first);
    const ElementShape second = basis.shape(pair.second);
    const auto add_values = [&](const ElementShape& shape, Point x, double sign, Eigen::VectorXd& difference) {
      const Eigen::RowVectorXd values = shape.values(x);
      for (int a = 0; a < shape.function_count(); ++a) {
        const auto place = std::lower_bound(pair.functions.begin(), pair.functions.end(),
                                            shape.functions[static_cast<std::size_t>(a)]);
        difference(place - pair.functions.begin()) += sign * values(a);
      }
    };
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(n, n);
    for (const int e : {pair.first, pair.second}) {
      const std::array<Point, 3> triangle = manifold.triangle(manifold.elements[static_cast<std::size_t>(e)]);
      for (const AreaPoint& p : triangle_rule(triangle, 2 * basis.degree())) {
        Eigen::VectorXd difference = Eigen::VectorXd::Zero(n);
        add_values(first, p.at, 1, difference);
        add_values(second, p.at, -1, difference);
        products += p.weight * difference * difference.transpose();
      }
    }
    const double h = (first.frame.size + second.frame.size) / 2;
    products *=
        std::max(stabilisation(basis.functions(pair.first)).ghost, stabilisation(basis.functions(pair.second)).ghost) *
        continuum.modulus(pair.first)(0, 0) / (h * h);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    for (Eigen::Index a = 0; a < n; ++a) {
      for (Eigen::Index b = 0; b < n; ++b) matrix(2 * a, 2 * b) = matrix(2 * a + 1, 2 * b + 1) = products(a, b);
    }
    system.add_matrix(pair.functions, matrix);
  }
}

}  // namespace keyblock
