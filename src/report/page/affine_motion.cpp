// Fits affine motions to the displacements of corners.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/affine_motion.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "geometry/polygon.hpp"

namespace keyblock::report {
namespace {

constexpr double kShare = 1e-5;       // of the largest displacement of a body: below the rounding to 14 bits
constexpr double kRoundOff = 1e-12;   // of the largest coordinate
constexpr double kSlenderest = 1e-9;  // ratio of widths of a body that has a gradient

/// Calls `visit(body, first, count)` for each loop.
template <class Visit>
void visit_loops(const PageShape& shape, const Visit& visit) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < shape.loop_body.size(); ++i) {
    visit(shape.loop_body[i], first, shape.loop_size[i]);
    first += shape.loop_size[i];
  }
}

/// Sums over the corners of a body, about its centroid.
struct Sums {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  Point move, move_x, move_y;  ///< displacement alone, times x, times y

  void add(Point at, Point by) {
    count += 1;
    x += at.x;
    y += at.y;
    xx += at.x * at.x;
    xy += at.x * at.y;
    yy += at.y * at.y;
    move = move + by;
    move_x = move_x + at.x * by;
    move_y = move_y + at.y * by;
  }

  AffineMotion fit() const {
    const double n = std::max(count, 1.0);
    const double sxx = xx - x * x / n, sxy = xy - x * y / n, syy = yy - y * y / n;
    const Point px = move_x - (x / n) * move, py = move_y - (y / n) * move;
    const double determinant = sxx * syy - sxy * sxy;
    Point along_x, along_y;  // columns of the gradient
    if (determinant > kSlenderest * kSlenderest * (sxx + syy) * (sxx + syy)) {
      along_x = (1 / determinant) * (syy * px - sxy * py);
      along_y = (1 / determinant) * (sxx * py - sxy * px);
    }
    const Point u = (1 / n) * (move - x * along_x - y * along_y);
    return {u.x, u.y, along_x.x, along_y.x, along_x.y, along_y.y};
  }
};

}  // namespace

std::vector<Point> centroids_of(const PageShape& shape) {
  std::vector<Point> sums(shape.bodies()), means(shape.bodies());
  std::vector<double> areas(shape.bodies(), 0), counts(shape.bodies(), 0);
  visit_loops(shape, [&](std::size_t body, std::size_t first, std::size_t count) {
    const std::span<const Point> loop(shape.places.data() + first, count);
    const double part = area(loop);  // negative for holes
    areas[body] += part;
    sums[body] = sums[body] + part * centroid(loop);
    for (const Point p : loop) means[body] = means[body] + p;
    counts[body] += static_cast<double>(count);
  });
  for (std::size_t b = 0; b < sums.size(); ++b)
    sums[b] = areas[b] > 0 ? (1 / areas[b]) * sums[b] : (1 / std::max(counts[b], 1.0)) * means[b];
  return sums;
}

BodyMotions motions_of(const PageShape& shape, const std::vector<Point>& centroids, const std::vector<Point>& moves) {
  std::vector<Sums> sums(shape.bodies());
  std::vector<double> most(shape.bodies(), 0);
  double extent = 0;
  visit_loops(shape, [&](std::size_t body, std::size_t first, std::size_t count) {
    for (std::size_t v = first; v < first + count; ++v) {
      sums[body].add(shape.places[v] - centroids[body], moves[v]);
      most[body] = std::max(most[body], length(moves[v]));
      extent = std::max({extent, std::abs(shape.places[v].x), std::abs(shape.places[v].y)});
    }
  });
  BodyMotions found;
  for (const Sums& of_body : sums) found.bodies.push_back(of_body.fit());
  visit_loops(shape, [&](std::size_t body, std::size_t first, std::size_t count) {
    const auto& [ux, uy, g11, g12, g21, g22] = found.bodies[body];
    const double bound = kShare * most[body] + kRoundOff * extent;
    for (std::size_t v = first; v < first + count; ++v) {
      const Point x = shape.places[v] - centroids[body];
      const Point by{ux + g11 * x.x + g12 * x.y, uy + g21 * x.x + g22 * x.y};
      if (distance(by, moves[v]) > bound) found.is_exact = false;
    }
  });
  return found;
}

}  // namespace keyblock::report
