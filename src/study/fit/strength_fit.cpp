// Fits a line and interprets its slope and intercept; see strength_fit.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/fit/strength_fit.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace keyblock::study {

StrengthFit fit_strength(const MeasuredPairs& tests) {
  const std::size_t count = tests.x.size();
  if (count < 2) throw InputError({tests.file, 0, 0}, fmt::format("expected at least 2 tests, found {}", count));
  for (std::size_t i = 0; i < count; ++i)
    if (tests.y[i] < tests.x[i])
      throw InputError(
          {tests.file, tests.lines[i], 1},
          fmt::format("expected s1 of at least s3 (compression positive), found {} below {}", tests.y[i], tests.x[i]));
  const auto [least, greatest] = std::ranges::minmax_element(tests.x);
  if (*least == *greatest)
    throw InputError({tests.file, 0, 0}, fmt::format("expected at least two values of s3, found {} alone", *least));
  double q = 0, ratio = 0, qq = 0, qr = 0, rr = 0, left = 0;
  gsl_fit_linear(tests.x.data(), 1, tests.y.data(), 1, count, &q, &ratio, &qq, &qr, &rr, &left);
  if (!(ratio >= 1 && q >= 0))
    throw InputError({tests.file, 0, 0},
                     fmt::format("expected s1 = N s3 + q with N of at least 1 and q of at least 0, as cohesion and "
                                 "friction make it, found N = {:.6g}, q = {:.6g}",
                                 ratio, q));
  const int freedom = static_cast<int>(count) - 2;
  const double root = std::sqrt(ratio);
  const double cohesion = q / (2 * root);
  const double by_q = 1 / (2 * root), by_ratio = -cohesion / (2 * ratio);
  const double variance = by_q * by_q * qq + 2 * by_q * by_ratio * qr + by_ratio * by_ratio * rr;
  // sin φ = (N - 1)/(N + 1), so that dφ/dN = 1 / ((N + 1) √N).
  const double degree = 180 / std::numbers::pi;
  StrengthFit fit;
  fit.ratio = found(ratio, std::sqrt(rr), freedom);
  fit.compressive_strength = found(q, std::sqrt(qq), freedom);
  fit.cohesion = found(cohesion, std::sqrt(std::max(variance, 0.0)), freedom);
  fit.friction_deg =
      found(degree * std::asin((ratio - 1) / (ratio + 1)), degree * std::sqrt(rr) / ((ratio + 1) * root), freedom);
  std::vector<double> line;
  for (const double s3 : tests.x) line.push_back(ratio * s3 + q);
  fit.agreement = agreement(tests.y, std::move(line));
  return fit;
}

}  // namespace keyblock::study
