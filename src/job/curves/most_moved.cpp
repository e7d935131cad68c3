// Lists the parts that a history follows and selects those that moved farthest.
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

constexpr std::size_t kMostCurves = 6;    // readers cannot distinguish more in one chart
constexpr std::size_t kMostColumns = 10;  // blocks of history.csv: with four columns each, still easy to read

bool is_in(const HistoryRow& row, std::size_t point) {
  return point < row.points.size() && is_there(row.points[point]);
}

// Parts that the rows of a history follow: measured points, blocks, or elements. Displacements of elements are averaged
// to those of their bodies.
struct FollowedParts {
  const char* word;
  std::vector<std::vector<std::pair<std::size_t, double>>> parts;  ///< of each part: points of a row with their weights
};

FollowedParts followed_by(const History& history, const Frame& start, const FieldFrame& field) {
  FollowedParts followed{history.of_measured_points ? "measured point" : "block", {}};
  const std::size_t count = history.rows.front().points.size();
  const bool have_changed = field.elements.size() != count;  // no body then tells the elements of the start
  if (have_changed && !history.of_measured_points && !field.is_of_blocks) followed.word = "element";
  if (history.of_measured_points || have_changed || body_count(field) == count) {
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

/// Returns the mean displacement of a part in a row; nothing if one of its points is not in the row.
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

using Parts = std::vector<std::pair<std::size_t, double>>;

// Returns all parts if there are few; otherwise those that moved farthest, the farthest first.
std::vector<std::size_t> farthest_of(const History& history, const std::vector<Parts>& all, std::size_t most,
                                     const std::vector<int>& hidden) {
  std::vector<std::size_t> shown(all.size());
  std::iota(shown.begin(), shown.end(), 0U);
  if (shown.size() <= most) return shown;
  std::erase_if(shown, [&](std::size_t i) { return std::ranges::find(hidden, static_cast<int>(i)) != hidden.end(); });
  std::vector<double> farthest(all.size(), 0);
  for (const std::size_t i : shown)
    for (const HistoryRow& row : history.rows)
      farthest[i] = std::max(farthest[i], displacement_of(row, all[i]).value_or(0));
  std::ranges::stable_sort(shown, std::ranges::greater(), [&](std::size_t i) { return farthest[i]; });
  shown.resize(std::min(most, shown.size()));
  return shown;
}

std::vector<std::size_t> shown_of(const Shown& all, const FollowedParts& followed) {
  const bool are_blocks = !all.history.of_measured_points && followed.parts.size() == all.field.elements.size();
  return farthest_of(all.history, followed.parts, kMostCurves, are_blocks ? all.hidden : std::vector<int>());
}

// Returns the place in the last row that has the whole part.
std::optional<Point> place_of(const History& history, const Parts& parts) {
  for (auto row = history.rows.rbegin(); row != history.rows.rend(); ++row) {
    Point at;
    bool is_whole = true;
    for (const auto& [point, share] : parts) {
      is_whole = is_whole && is_in(*row, point);
      if (is_whole) at = at + share * row->points[point].position;
    }
    if (is_whole) return at;
  }
  return std::nullopt;
}

}  // namespace

// Returns one curve of displacement over time per shown part.
std::vector<report::Curve> displacement_curves(const Shown& all) {
  const History& history = all.history;
  std::vector<report::Curve> curves;
  if (history.rows.empty()) return curves;
  const FollowedParts followed = followed_by(history, all.start, all.field);
  const std::vector<std::size_t> shown = shown_of(all, followed);
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

std::vector<report::NumberedPlace> numbers_of_curves(const Shown& all) {
  std::vector<report::NumberedPlace> numbers;
  if (all.history.rows.empty()) return numbers;
  const FollowedParts followed = followed_by(all.history, all.start, all.field);
  for (const std::size_t i : shown_of(all, followed))
    if (const std::optional<Point> at = place_of(all.history, followed.parts[i]))
      numbers.push_back({fmt::format("{}", i + 1), *at});
  return numbers;
}

std::string numbered_words(const Shown& all) {
  if (all.history.rows.empty()) return {};
  return fmt::format("{} whose curve is drawn", followed_by(all.history, all.start, all.field).word);
}

std::vector<std::size_t> columns_of_history(const History& history, const std::vector<int>& hidden) {
  std::size_t most = 0;
  for (const HistoryRow& row : history.rows) most = std::max(most, row.points.size());
  if (history.of_measured_points || most <= kMostColumns) return {};
  std::vector<Parts> all;
  for (std::size_t i = 0; i < most; ++i) all.push_back({{i, 1.0}});
  std::vector<std::size_t> chosen = farthest_of(history, all, kMostColumns, hidden);
  std::ranges::sort(chosen);
  return chosen;
}

std::string most_moved_rows(const Shown& all, const Units& units) {
  const History& history = all.history;
  std::string text;
  if (history.rows.empty()) return text;
  const std::string unit = unit_of(measures::kLength, units);
  const FollowedParts followed = followed_by(history, all.start, all.field);
  const std::vector<std::size_t> shown = shown_of(all, followed);
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
