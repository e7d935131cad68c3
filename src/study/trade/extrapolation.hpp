// Where runs lead as they are refined: the limit of values at h, h/2 and h/4, after Richardson (1911).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace keyblock::study {

/// What h is: the integrators are of first or second order in steps, functions of any order in sides of a mesh.
enum class Refined { step, mesh };

struct Limit {
  std::vector<double> values;
  std::optional<double> order;  ///< observed, of h; nothing where the three are the same
  bool is_extrapolated = false;
  /// Of `values`, relative: what extrapolation of at most second order adds to the finest run or, without it, how far
  /// the others are from that at most.
  double uncertainty = 0;
};

/// Root mean square of `a` less `b` over that of `b`; of equal length. Where `b` is 0 throughout, not divided by it.
double relative_distance(const std::vector<double>& a, const std::vector<double>& b);

/// The limit of values of equal length, coarsest first, each of half the h of the one before. The order p = log2(|a -
/// b| / |b - c|) is common to all values. Where it is below 0.4 or above 6, differences do not shrink as those of a
/// convergent method: then the limit is the finest as it is. Where steps show more than 2.5, a term of first and one of
/// second order cancel in part: both are taken out, and the limit is known to what that changes, or to a third of what
/// lies between the first and the last, as at first order, whichever is greater: they may cancel by chance.
Limit limit_of(const std::array<std::vector<double>, 3>& values, Refined refined);

}  // namespace keyblock::study
