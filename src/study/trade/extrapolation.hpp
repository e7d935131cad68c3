// Estimates the limit of refined runs: of values at h, h/2 and h/4, after Richardson (1911).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace keyblock::study {

/// Meaning of h. The integrators are of first or second order in steps; functions have any order in sides of a mesh.
enum class Refined { step, mesh };

struct Limit {
  std::vector<double> values;
  std::optional<double> order;  ///< observed, of h; empty if the three are the same
  bool is_extrapolated = false;
  /// Uncertainty of `values`, relative. It is the change by extrapolation of at most second order. Without
  /// extrapolation it is the greatest distance of the other runs.
  double uncertainty = 0;
};

/// Returns the root mean square of `a` less `b` over that of `b`, both of equal length. If `b` is 0 throughout, it is
/// not divided.
double relative_distance(const std::vector<double>& a, const std::vector<double>& b);

/// Returns the limit of values of equal length, coarsest first, each with half the h of the one before. The order p =
/// log2(|a - b| / |b - c|) is common to all values. If it is below 0.4 or above 6, the method does not converge there,
/// and the limit is the finest run. If steps show more than 2.5, terms of first and second order cancel in part, and
/// both are removed. The uncertainty is then the change by this, or a third of the difference of the first and the
/// last, as at first order. The larger counts, because terms may cancel by chance.
Limit limit_of(const std::array<std::vector<double>, 3>& values, Refined refined);

}  // namespace keyblock::study
