// What a history follows, and which of it comes farthest.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/curves/most_moved.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "problem/units/measure.hpp"

namespace keyblock {
namespace {

constexpr std::size_t kMostCurves = 6;  // more cannot be told apart in one chart

bool is_in(const HistoryRow& row, std::size_t point) {
  return point < row.points.size() && is_there(row.points[point]);
}

// What the rows of a history hold: measured points, blocks, or the elements of bodies, whose displacements are weighed
// to the bodies'.
struct FollowedParts {
  const char* word;
  std::vector<std::vector<std::pair<std::size_t, double>>> parts;  ///< of each: points of a row with their shares
};

FollowedParts followed_by(const History& history, const Frame& start, const FieldFrame& field) {
  FollowedParts followed{history.of_measured_points ? "measured point" : "block", {}};
  const std::size_t count = history.rows.front().points.size();
  const bool are_blocks = field.elements.size() != count || body_count(field) == count;
  if (history.of_measured_points || are_blocks) {
    for (std::size_t i = 0; i < count; ++i) followed.parts.push_back({{i, 1.0}});
    return followed;
  }
  followed.word = "body";
  std::vector<double> masses;
  for (std::size_t e = 0; e < count; ++e) {
    const auto body = static_cast<std::size_t>(field.elements[e].body);
    followed.parts.resize(std::max(followed.parts.size(), body + 1));
    masses.resize(followed.parts.size());
    followed.parts[body].emplace_back(e, start.elements[e].mass);
    masses[body] += start.elements[e].mass;
  }
  for (std::size_t body = 0; body < masses.size(); ++body)
    for (auto& [element, share] : followed.parts[body]) share /= masses[body];
  return followed;
}

/// Of some of what a history follows the displacement in a row; none where it is not there.
std::optional<Point> way_of(const HistoryRow& row, const std::vector<std::pair<std::size_t, double>>& parts) {
  Point mean;
  for (const auto& [point, share] : parts) {
    if (!is_in(row, point)) return std::nullopt;
    mean = mean + share * row.points[point].displacement;
  }
  return mean;
}

std::optional<double> displacement_of(const HistoryRow& row, const std::vector<std::pair<std::size_t, double>>& parts) {
  const std::optional<Point> way = way_of(row, parts);
  return way ? std::optional(length(*way)) : std::nullopt;
}

// All of few; of many those that came farthest, the first of them first.
std::vector<std::size_t> shown_of(const History& history, const FollowedParts& followed) {
  std::vector<double> farthest;
  for (const auto& parts : followed.parts) {
    double& most = farthest.emplace_back(0);
    for (const HistoryRow& row : history.rows) most = std::max(most, displacement_of(row, parts).value_or(0));
  }
  std::vector<std::size_t> shown(followed.parts.size());
  std::iota(shown.begin(), shown.end(), 0U);
  if (shown.size() <= kMostCurves) return shown;
  std::ranges::stable_sort(shown, std::ranges::greater(), [&](std::size_t i) { return farthest[i]; });
  shown.resize(kMostCurves);
  return shown;
}

}  // namespace

// How far each of them has come, over time.
std::vector<report::Curve> displacement_curves(const History& history, const Frame& start, const FieldFrame& field) {
  std::vector<report::Curve> curves;
  if (history.rows.empty()) return curves;
  const FollowedParts followed = followed_by(history, start, field);
  const std::vector<std::size_t> shown = shown_of(history, followed);
  for (const std::size_t i : shown) {
    report::Curve curve;
    const bool is_last_of_more = i == shown.back() && followed.parts.size() > shown.size();
    curve.label =
        fmt::format("{} {}{}", followed.word, i + 1,
                    is_last_of_more ? fmt::format(" (of {}: those that move most)", followed.parts.size()) : "");
    for (const HistoryRow& row : history.rows)
      if (const std::optional<double> way = displacement_of(row, followed.parts[i])) {
        curve.x.push_back(row.time);
        curve.y.push_back(*way);
      }
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::string most_moved_rows(const History& history, const Frame& start, const FieldFrame& field, const Units& units) {
  std::string text;
  if (history.rows.empty()) return text;
  const std::string unit = unit_of(measures::kLength, units);
  const FollowedParts followed = followed_by(history, start, field);
  const std::vector<std::size_t> shown = shown_of(history, followed);
  for (const HistoryRow& row : history.rows)
    for (const std::size_t i : shown) {
      const std::optional<Point> way = way_of(row, followed.parts[i]);
      if (!way) continue;
      for (const auto& [quantity, value] : {std::pair("displacement_x", way->x), std::pair("displacement_y", way->y)})
        text += fmt::format("{},{:.12g},{},{},{},{:.12g},{}\n", row.step, row.time, followed.word, i + 1, quantity,
                            value, unit);
    }
  return text;
}

}  // namespace keyblock
