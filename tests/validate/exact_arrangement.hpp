// Counts the vertices and edges of lines between lattice points in whole numbers: slow, simple and without
// rounding.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "problem/drawing.hpp"

namespace keyblock {

/// A point with rational coordinates x / w, y / w in lowest terms, w > 0.
struct RationalPoint {
  std::int64_t x;
  std::int64_t y;
  std::int64_t w;

  auto operator<=>(const RationalPoint&) const = default;
};

struct WholeLine {
  std::int64_t x;
  std::int64_t y;
  std::int64_t dx;
  std::int64_t dy;
};

inline WholeLine whole(const Segment& s) {
  return {static_cast<std::int64_t>(s.start.x), static_cast<std::int64_t>(s.start.y),
          static_cast<std::int64_t>(s.end.x - s.start.x), static_cast<std::int64_t>(s.end.y - s.start.y)};
}

inline bool is_on(const WholeLine& line, const RationalPoint& p) {
  const std::int64_t px = p.x - line.x * p.w;
  const std::int64_t py = p.y - line.y * p.w;
  const std::int64_t along = px * line.dx + py * line.dy;
  return px * line.dy == py * line.dx && along >= 0 && along <= (line.dx * line.dx + line.dy * line.dy) * p.w;
}

inline RationalPoint reduced(std::int64_t x, std::int64_t y, std::int64_t w) {
  const std::int64_t divisor = (w < 0 ? -1 : 1) * std::gcd(std::gcd(x, y), w);
  return {x / divisor, y / divisor, w / divisor};
}

/// Returns the places where two lines meet: the crossing, or the ends of their overlap.
inline std::vector<RationalPoint> meetings(const WholeLine& a, const WholeLine& b) {
  std::vector<RationalPoint> candidates;
  const std::int64_t w = a.dx * b.dy - a.dy * b.dx;
  if (w != 0) {
    const std::int64_t t = (b.x - a.x) * b.dy - (b.y - a.y) * b.dx;
    candidates = {reduced(a.x * w + t * a.dx, a.y * w + t * a.dy, w)};
  } else {
    candidates = {{a.x, a.y, 1}, {a.x + a.dx, a.y + a.dy, 1}, {b.x, b.y, 1}, {b.x + b.dx, b.y + b.dy, 1}};
  }
  std::erase_if(candidates, [&](const RationalPoint& p) { return !is_on(a, p) || !is_on(b, p); });
  return candidates;
}

struct ExactCounts {
  int vertices = 0;
  int edges = 0;
};

/// Counts over all pairs; nothing is pruned.
inline ExactCounts count_exactly(const Drawing& drawing) {
  std::vector<WholeLine> lines;
  for (const JointLine& line : drawing.joints) lines.push_back(whole(line.segment));
  std::set<RationalPoint> vertices;
  std::set<std::pair<RationalPoint, RationalPoint>> edges;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::set<RationalPoint> on_line;
    for (std::size_t j = 0; j < lines.size(); ++j) {
      if (i == j) continue;
      for (const RationalPoint& p : meetings(lines[i], lines[j])) on_line.insert(p);
    }
    std::vector<RationalPoint> ordered(on_line.begin(), on_line.end());
    std::sort(ordered.begin(), ordered.end(), [&](const RationalPoint& p, const RationalPoint& q) {
      return (p.x * lines[i].dx + p.y * lines[i].dy) * q.w < (q.x * lines[i].dx + q.y * lines[i].dy) * p.w;
    });
    for (std::size_t k = 1; k < ordered.size(); ++k) {
      edges.insert({std::min(ordered[k - 1], ordered[k]), std::max(ordered[k - 1], ordered[k])});
    }
    vertices.merge(on_line);
  }
  return {static_cast<int>(vertices.size()), static_cast<int>(edges.size())};
}

}  // namespace keyblock
