// Compares successive rows with growing displacement; see reaction_curve.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/reaction_curve.hpp"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

// Relative change of the reaction over that of the displacement: at twice the displacement it grows by 0.35 % at most.
constexpr double kSmallSlope = 0.005;
constexpr std::size_t kFewest = 3;  // rows in a plateau
// Least length of a plateau over the displacement at its start; a shorter one may be a kink of the curve.
constexpr double kFurther = 0.1;

bool has(const HistoryRow& row, std::size_t number) {
  return number < row.driven.size() && number < row.reactions.size();
}

double relative_change(const ReactionCurve& curve, std::size_t i) {
  const double change = curve.reaction[i] - curve.reaction[i - 1];
  return curve.reaction[i] == 0 ? 1 : std::abs(change / curve.reaction[i]);
}

double relative_way(const ReactionCurve& curve, std::size_t i) {
  return (curve.driven[i] - curve.driven[i - 1]) / curve.driven[i];
}

bool stands(const ReactionCurve& curve, std::size_t i) {
  return relative_change(curve, i) < kSmallSlope * relative_way(curve, i);
}

}  // namespace

std::vector<ReactionCurve> reaction_curves(const History& history) {
  std::vector<ReactionCurve> curves;
  if (history.rows.empty()) return curves;
  const HistoryRow& last = history.rows.back();
  for (std::size_t number = 0; has(last, number); ++number) {
    ReactionCurve curve;
    curve.number = number;
    const Point end = last.reactions[number];
    constexpr double kAlike = 0.01;  // both components of a symmetric edge are equal up to the mesh
    curve.component = std::abs(end.y) > (1 + kAlike) * std::abs(end.x) ? 'y' : 'x';
    curve.is_at_end = false;
    for (const HistoryRow& row : history.rows) {
      curve.is_at_end = false;
      if (!has(row, number) || (!curve.driven.empty() && row.driven[number] <= curve.driven.back())) continue;
      curve.steps.push_back(row.step);
      curve.driven.push_back(row.driven[number]);
      curve.reaction.push_back(curve.component == 'x' ? row.reactions[number].x : row.reactions[number].y);
      curve.is_at_end = true;
    }
    if (curve.driven.size() > 1) curves.push_back(std::move(curve));
  }
  return curves;
}

std::optional<double> end_slope(const ReactionCurve& curve) {
  const std::size_t last = curve.driven.size() - 1;
  if (curve.driven.size() < 2 || !curve.is_at_end || curve.reaction[last] == 0) return std::nullopt;
  return (curve.reaction[last] - curve.reaction[last - 1]) / curve.reaction[last] / relative_way(curve, last);
}

std::optional<std::size_t> plateau_of(const ReactionCurve& curve) {
  if (curve.driven.size() <= kFewest || !curve.is_at_end) return std::nullopt;
  std::size_t first = curve.driven.size() - 1;
  while (first > 0 && stands(curve, first)) --first;
  if (curve.driven.size() - 1 - first < kFewest) return std::nullopt;
  if (curve.driven.back() < (1 + kFurther) * curve.driven[first]) return std::nullopt;
  return first;
}

}  // namespace keyblock
