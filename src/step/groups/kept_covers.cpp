// Compares triangle by triangle, then function by function; see kept_covers.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/groups/kept_covers.hpp"

#include <algorithm>

#include "cut/mesh/same_triangles.hpp"

namespace keyblock {
namespace {

constexpr double kRounding = 1e-12;  // of coefficients, which are about 1

const ManifoldElement& element_of(const CoverScene& scene, int e) {
  return scene.continuum().manifold.elements[static_cast<std::size_t>(e)];
}

/// Compares the polynomials of two elements. `functions`: earlier function of each later one.
bool has_same_polynomials(const ElementShape& was, const ElementShape& is, const std::vector<int>& functions) {
  if (was.function_count() != is.function_count() || was.degree != is.degree) return false;
  if (was.frame.origin != is.frame.origin || was.frame.size != is.frame.size) return false;
  for (int a = 0; a < is.function_count(); ++a) {
    const int function = functions[static_cast<std::size_t>(is.functions[static_cast<std::size_t>(a)])];
    const auto found = std::ranges::find(was.functions, function);
    if (found == was.functions.end()) return false;
    const auto b = static_cast<Eigen::Index>(found - was.functions.begin());
    if (!((was.monomial.col(b) - is.monomial.col(a)).cwiseAbs().maxCoeff() <= kRounding)) return false;
  }
  return true;
}

}  // namespace

KeptCovers nothing_kept(const CoverScene& after) {
  const auto elements = static_cast<std::size_t>(after.basis().element_count());
  return {std::vector<int>(elements, -1),
          std::vector<int>(static_cast<std::size_t>(after.basis().function_count()), -1),
          std::vector<char>(elements, 0)};
}

KeptCovers kept_covers(const CoverScene& before, std::span<const int> parents, const CoverScene& after) {
  KeptCovers kept = nothing_kept(after);
  const CoverBasis& was = before.basis();
  const CoverBasis& is = after.basis();
  if (was.functions() != is.functions() || was.has_tip_functions() || is.has_tip_functions()) return kept;
  const Manifold& manifold_before = before.continuum().manifold;
  const Manifold& manifold = after.continuum().manifold;
  const int per_cover = is.function_count() / static_cast<int>(manifold.covers.size());
  for (std::size_t e = 0; e < parents.size(); ++e) {
    if (parents[e] < 0) continue;
    const ManifoldElement& old = element_of(before, parents[e]);
    const ManifoldElement& element = manifold.elements[e];
    if (manifold_before.triangle(old) != manifold.triangle(element)) continue;
    kept.in_triangle[e] = parents[e];
    for (std::size_t k = 0; k < 3; ++k)
      for (int m = 0; m < per_cover; ++m)
        kept.functions[static_cast<std::size_t>(element.covers[k] * per_cover + m)] = old.covers[k] * per_cover + m;
  }
  for (std::size_t e = 0; e < parents.size(); ++e) {
    const int parent = kept.in_triangle[e];
    kept.elements[e] = parent >= 0 &&
                       have_same_polygon(manifold_before, element_of(before, parent), manifold, manifold.elements[e]) &&
                       has_same_polynomials(was.shape(parent), is.shape(static_cast<int>(e)), kept.functions);
  }
  return kept;
}

Eigen::VectorXd copied(const KeptCovers& kept, const Eigen::VectorXd& field) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(kept.functions.size()));
  for (std::size_t f = 0; f < kept.functions.size(); ++f)
    if (kept.functions[f] >= 0)
      result.segment<2>(2 * static_cast<Eigen::Index>(f)) = field.segment<2>(2 * kept.functions[f]);
  return result;
}

}  // namespace keyblock
