// Finds pairs of lines that meet; see crossings.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/segment.hpp"
#include "problem/lines/segment_grid.hpp"

namespace keyblock {
namespace {

/// Error of floating-point stations above which exact ones are computed. Lines almost along each other have such
/// errors, and their crossing may get beyond other crossings of either line.
constexpr double kRoughStation = 1e-10;

bool is_in_box(const Segment& s, Point p) {
  const auto [x0, x1] = std::minmax(s.start.x, s.end.x);
  const auto [y0, y1] = std::minmax(s.start.y, s.end.y);
  return x0 <= p.x && p.x <= x1 && y0 <= p.y && p.y <= y1;
}

/// Finds the meetings of one pair at a time and keeps them.
class PairTest {
 public:
  PairTest(std::span<const Segment> lines, const CutTolerances& tolerances) : lines_(lines) {
    if (tolerances.is_exact()) return;
    for (const Segment& s : lines) {
      reach_.push_back(std::max(tolerances.reach_ratio * distance(s.start, s.end), tolerances.round_off));
    }
  }

  double greatest_reach() const { return reach_.empty() ? 0 : *std::max_element(reach_.begin(), reach_.end()); }

  void test(int line, int other) {
    if (reach_.empty()) {
      test_exactly(line, other);
    } else {
      test_within_reach(line, other);
    }
  }

  std::vector<Crossing> take() { return std::move(found_); }

 private:
  void test_exactly(int line, int other) {
    switch (meeting(lines_[line], lines_[other])) {
      case Meeting::none:
        return;
      case Meeting::crossing:
        return add_crossing(line, other);
      case Meeting::overlapping:
        return add_ends(line, other, [](const Segment& s, Point p) { return is_in_box(s, p); });
    }
  }

  void test_within_reach(int line, int other) {
    const Segment& a = lines_[line];
    const Segment& b = lines_[other];
    const double reach = std::max(reach_[line], reach_[other]);
    if (!boxes_meet(a, b, reach)) return;
    if (is_along(a, b, reach)) {
      return add_ends(line, other, [reach](const Segment& s, Point p) { return distance(s, p) <= reach; });
    }
    if (meeting(a, b) != Meeting::none) return add_crossing(line, other);
    if (!is_reached(a, b, reach_[line]) || !is_reached(b, a, reach_[other])) return;
    add_crossing(line, other);
    found_.back().is_reached = true;
  }

  static bool boxes_meet(const Segment& a, const Segment& b, double reach) {
    return std::min(a.start.x, a.end.x) - reach <= std::max(b.start.x, b.end.x) &&
           std::min(b.start.x, b.end.x) - reach <= std::max(a.start.x, a.end.x) &&
           std::min(a.start.y, a.end.y) - reach <= std::max(b.start.y, b.end.y) &&
           std::min(b.start.y, b.end.y) - reach <= std::max(a.start.y, a.end.y);
  }

  /// Returns true if the shorter of the two lies on the straight line of the longer.
  static bool is_along(const Segment& a, const Segment& b, double reach) {
    const bool a_is_longer = distance(a.start, a.end) > distance(b.start, b.end);
    const Segment& carrier = a_is_longer ? a : b;
    const Segment& shorter = a_is_longer ? b : a;
    return distance_to_carrier(carrier, shorter.start) <= reach && distance_to_carrier(carrier, shorter.end) <= reach;
  }

  static bool is_reached(const Segment& base, const Segment& mark, double reach) {
    const double t = station(base, mark).value;
    const double slack = reach / distance(base.start, base.end);
    return -slack <= t && t <= 1 + slack;
  }

  void add_crossing(int line, int other) {
    Station t = station(lines_[line], lines_[other]);
    if (!(t.error <= kRoughStation)) t = exact_station(lines_[line], lines_[other]);
    found_.push_back({line, other, point_at(lines_[line], t.value), false, false});
  }

  /// Adds the ends of the lower line first, as Shi's programs do.
  template <class IsOn>
  void add_ends(int line, int other, IsOn is_on) {
    const Segment& a = lines_[line];
    const Segment& b = lines_[other];
    const std::size_t before = found_.size();
    const auto add = [&](const Segment& s, Point p) {
      if (!is_on(s, p)) return;
      for (std::size_t k = before; k < found_.size(); ++k) {
        if (found_[k].position == p) return;
      }
      found_.push_back({line, other, p, true, false});
    };
    add(a, b.start);
    add(a, b.end);
    add(b, a.start);
    add(b, a.end);
  }

  std::span<const Segment> lines_;
  std::vector<double> reach_;  // empty: exact
  std::vector<Crossing> found_;
};

/// Collects the stops of every line, not yet in order.
void collect_stops(std::span<const Segment> lines, Crossings& crossings) {
  crossings.first_stop.assign(lines.size() + 1, 0);
  for (const Crossing& c : crossings.found) {
    ++crossings.first_stop[c.line + 1];
    ++crossings.first_stop[c.other + 1];
  }
  for (std::size_t i = 1; i < crossings.first_stop.size(); ++i) crossings.first_stop[i] += crossings.first_stop[i - 1];
  crossings.stops.resize(crossings.first_stop.back());
  std::vector<std::size_t> next(crossings.first_stop.begin(), crossings.first_stop.end() - 1);
  for (std::size_t k = 0; k < crossings.found.size(); ++k) {
    const Crossing& c = crossings.found[k];
    const Segment end{c.position, c.position};
    const int index = static_cast<int>(k);
    crossings.stops[next[c.line]++] = {station(lines[c.line], c.is_end ? end : lines[c.other]), index};
    crossings.stops[next[c.other]++] = {station(lines[c.other], c.is_end ? end : lines[c.line]), index};
  }
}

/// Compares two stops of one line exactly.
class StopOrder {
 public:
  StopOrder(std::span<const Segment> lines, const std::vector<Crossing>& found, int line)
      : lines_(lines), found_(found), line_(line) {}

  int compare(const Stop& a, const Stop& b) const {
    if (is_order_certain(a.station, b.station)) return a.station.value < b.station.value ? -1 : 1;
    if (a.crossing == b.crossing) return 0;
    return compare_stations(lines_[line_], mark(a), mark(b));
  }

 private:
  Segment mark(const Stop& stop) const {
    const Crossing& c = found_[stop.crossing];
    if (c.is_end) return {c.position, c.position};
    return lines_[c.line == line_ ? c.other : c.line];
  }

  std::span<const Segment> lines_;
  const std::vector<Crossing>& found_;
  int line_;
};

}  // namespace

Crossings find_crossings(std::span<const Segment> lines, const CutTolerances& tolerances) {
  PairTest pairs(lines, tolerances);
  SegmentGrid grid(lines, pairs.greatest_reach());
  for (int i = 1; i < static_cast<int>(lines.size()); ++i) {
    for (const int j : grid.near(lines[i], i)) pairs.test(i, j);
  }
  Crossings result;
  result.found = pairs.take();
  collect_stops(lines, result);
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const StopOrder order(lines, result.found, static_cast<int>(line));
    const auto begin = result.stops.begin() + static_cast<std::ptrdiff_t>(result.first_stop[line]);
    const auto end = result.stops.begin() + static_cast<std::ptrdiff_t>(result.first_stop[line + 1]);
    std::sort(begin, end, [&](const Stop& a, const Stop& b) {
      const int way = order.compare(a, b);
      return way != 0 ? way < 0 : a.crossing < b.crossing;
    });
    for (std::size_t k = result.first_stop[line] + 1; k < result.first_stop[line + 1]; ++k) {
      if (order.compare(result.stops[k - 1], result.stops[k]) == 0) result.equal_before.push_back(k);
    }
  }
  return result;
}

}  // namespace keyblock
