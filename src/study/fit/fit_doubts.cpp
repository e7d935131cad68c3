// Compares means of neighbouring values, which suppress noise.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/fit/fit_doubts.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentences/sentences.hpp"

namespace keyblock::study {
namespace {

constexpr double kLeastAgreement = 0.9;  // R²
constexpr double kOneSided = 0.05;       // of the greatest value
constexpr double kFall = 0.1;            // of the peak
constexpr std::size_t kFewNeighbours = 3;

/// Returns the means of every `count` neighbouring values.
std::vector<double> means(const std::vector<double>& values, std::size_t count) {
  std::vector<double> found;
  for (std::size_t i = 0; i + count <= values.size(); ++i) {
    double sum = 0;
    for (std::size_t k = i; k < i + count; ++k) sum += values[k];
    found.push_back(sum / static_cast<double>(count));
  }
  return found;
}

double greatest_size(const std::vector<double>& values) {
  double greatest = 0;
  for (const double value : values) greatest = std::max(greatest, std::abs(value));
  return greatest;
}

}  // namespace

Warnings doubts_of_fit(const MeasuredPairs& measured, const Agreement& agreement) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < measured.y.size(); ++i) residuals.push_back(measured.y[i] - agreement.fitted[i]);
  const std::size_t neighbours = std::max(kFewNeighbours, measured.y.size() / 10);
  const double share = greatest_size(means(residuals, neighbours)) / greatest_size(measured.y);
  if (agreement.r_squared >= kLeastAgreement && share <= kOneSided) return {};
  const Facts facts{
      {{"r_squared", agreement.r_squared}, {"neighbours", neighbours}, {"percent_of_greatest", 100 * share}}};
  return {warning_of({"poor_fit", facts}, {measured.file, 0, 0})};
}

Warnings doubts_of_curve(const MeasuredPairs& measured) {
  const std::vector<double> stresses = means(measured.y, kFewNeighbours);
  const auto peak = std::ranges::max_element(stresses);
  if (peak == stresses.end() || !(stresses.back() < (1 - kFall) * *peak)) return {};
  const std::size_t at = static_cast<std::size_t>(peak - stresses.begin()) + kFewNeighbours / 2;
  const Facts facts{{{"peak", measured.y[at]}, {"strain", measured.x[at]}, {"last", measured.y.back()}}};
  return {warning_of({"softening", facts}, {measured.file, measured.lines[at], 1})};
}

}  // namespace keyblock::study
