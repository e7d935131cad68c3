// Converts areas row by row: edges cross the centres of rows, and the area lies between a crossing and the next one.
// The second area of a row begins at the third crossing, which leaves holes open (even-odd rule).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/raster.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "geometry/box.hpp"

namespace keyblock::report {
namespace {

constexpr double kThin = 1.5;      // pixels: narrower lines are one pixel wide
constexpr double kLeastCell = 4;   // pixels: thin edges of smaller shapes would hide their colours
constexpr double kMostSide = 1e4;  // pixels of a page

/// The first pixel whose centre is not before `at`, within 0 and `end`.
int first_from(double at, int end) {
  return static_cast<int>(std::clamp(std::ceil(at - 0.5), 0.0, static_cast<double>(end)));
}

std::uint32_t with_opacity(std::uint32_t colour, double opacity) {
  return (colour & 0xFFFFFF) | static_cast<std::uint32_t>(std::lround(255 * std::clamp(opacity, 0.0, 1.0))) << 24;
}

/// Returns the mean of two colours with the weights `a` and `rest`, whose sum is `opacity`.
template <class Opacity>
std::uint32_t mixed(std::uint32_t below, std::uint32_t above, std::uint32_t a, std::uint32_t rest, Opacity opacity) {
  std::uint32_t mixed = static_cast<std::uint32_t>(opacity) << 24;
  for (const int shift : {16, 8, 0}) {
    const std::uint32_t sum = ((above >> shift) & 0xFF) * a + ((below >> shift) & 0xFF) * rest;
    mixed |= (sum + opacity / 2) / opacity << shift;
  }
  return mixed;
}

// Most pixels are opaque. Division by a constant is much faster.
std::uint32_t over(std::uint32_t below, std::uint32_t above) {
  using Opaque = std::integral_constant<std::uint32_t, 255>;
  const std::uint32_t a = above >> 24, rest = (below >> 24) * (255 - a) / 255;
  const std::uint32_t opacity = a + rest;
  if (opacity == Opaque::value) return mixed(below, above, a, rest, Opaque());
  return opacity == 0 ? 0 : mixed(below, above, a, rest, opacity);
}

/// Opacity of the edges of a shape; see `Raster::draw`.
double opacity_of(const std::vector<std::vector<Point>>& loops, bool is_closed, const Ink& ink) {
  const double opacity = std::min(1.0, kPixelsPerUnit * ink.width);
  if (opacity == 1 || !is_closed || ink.dash > 0) return opacity;
  keyblock::Box box;
  for (const std::vector<Point>& loop : loops)
    for (const Point p : loop) box.add(p);
  const double size = kPixelsPerUnit * std::max(box.size().x, box.size().y);
  return opacity * std::clamp(size / kLeastCell - 1, 0.0, 1.0);
}

int pixels_of(double units) {
  return static_cast<int>(std::clamp(std::ceil(kPixelsPerUnit * units), 1.0, kMostSide));
}

}  // namespace

Raster::Raster(double width, double height)
    : width_(pixels_of(width)),
      height_(pixels_of(height)),
      pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)),
      quad_(1, std::vector<Point>(4)) {}

void Raster::draw(const std::vector<std::vector<Point>>& loops, bool is_closed, const Ink& ink) {
  if (ink.fill != 0) fill(loops, ink.fill);
  if (ink.stroke == 0 || ink.stroke == ink.fill) return;
  const std::uint32_t colour = with_opacity(ink.stroke, opacity_of(loops, is_closed, ink));
  if (colour >> 24 == 0) return;
  for (const std::vector<Point>& loop : loops) edges(loop, is_closed, ink, colour);
}

void Raster::draw_line(std::span<const Point> points, const Ink& ink) {
  const std::uint32_t colour = with_opacity(ink.stroke, std::min(1.0, kPixelsPerUnit * ink.width));
  if (ink.stroke != 0 && colour >> 24 != 0) edges(points, false, ink, colour);
}

void Raster::fill(const std::vector<std::vector<Point>>& loops, std::uint32_t colour) {
  crossings_.clear();
  for (const std::vector<Point>& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      Point a = kPixelsPerUnit * loop[i], b = kPixelsPerUnit * loop[i + 1 == loop.size() ? 0 : i + 1];
      if (a.y > b.y) std::swap(a, b);
      const int end = first_from(b.y, height_);
      int row = first_from(a.y, height_);
      if (row >= end) continue;
      const double slope = (b.x - a.x) / (b.y - a.y);
      for (; row < end; ++row) crossings_.push_back({row, a.x + slope * (row + 0.5 - a.y)});
    }
  std::sort(crossings_.begin(), crossings_.end(),
            [](const Crossing& a, const Crossing& b) { return a.row != b.row ? a.row < b.row : a.x < b.x; });
  for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
    const int from = first_from(crossings_[i].x, width_), to = first_from(crossings_[i + 1].x, width_);
    const auto row = pixels_.begin() + static_cast<std::ptrdiff_t>(crossings_[i].row) * width_;
    std::fill(row + from, row + std::max(from, to), colour);
  }
}

void Raster::edges(std::span<const Point> loop, bool is_closed, const Ink& ink, std::uint32_t colour) {
  double along = 0;
  for (std::size_t i = 0; i + (is_closed ? 0 : 1) < loop.size(); ++i) {
    const Point to = loop[i + 1 == loop.size() ? 0 : i + 1];
    if (ink.dash > 0)
      dashes(loop[i], to, ink, colour, along);
    else
      piece(loop[i], to, ink, colour);
  }
}

/// `along`: length of the line so far.
void Raster::dashes(Point from, Point to, const Ink& ink, std::uint32_t colour, double& along) {
  const double size = distance(from, to), period = ink.dash + ink.gap;
  if (!(size > 0)) return;
  const auto at = [&](double length) { return from + (std::clamp(length, 0.0, size) / size) * (to - from); };
  const double page = (width_ + height_) / kPixelsPerUnit;
  for (double start = -std::fmod(along, period); start < std::min(size, page); start += period)
    if (start + ink.dash > 0) piece(at(start), at(start + ink.dash), ink, colour);
  along += size;
}

void Raster::piece(Point from, Point to, const Ink& ink, std::uint32_t colour) {
  if (kPixelsPerUnit * ink.width < kThin) return thin_line(kPixelsPerUnit * from, kPixelsPerUnit * to, colour);
  const double size = distance(from, to);
  if (!(size > 0)) return;
  const Point half = (ink.width / 2 / size) * (to - from);
  const Point across{-half.y, half.x};
  const Point more = ink.dash > 0 ? Point{} : half;  // fills the corners between lines
  quad_[0] = {from - more + across, to + more + across, to + more - across, from - more - across};
  fill(quad_, colour);
}

/// Draws one pixel of each column, or of each row if the line is steep.
void Raster::thin_line(Point a, Point b, std::uint32_t colour) {
  const bool is_steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  if (is_steep) {
    a = {a.y, a.x};
    b = {b.y, b.x};
  }
  if (a.x > b.x) std::swap(a, b);
  const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
  const int end = first_from(b.x, is_steep ? height_ : width_);
  const double most = is_steep ? width_ : height_;
  for (int i = first_from(a.x, end); i < end; ++i) {
    const double other = a.y + slope * (i + 0.5 - a.x);
    if (!(other >= 0 && other < most)) continue;
    const int j = static_cast<int>(other);
    is_steep ? blend(j, i, colour) : blend(i, j, colour);
  }
}

void Raster::blend(int column, int row, std::uint32_t colour) {
  std::uint32_t& pixel =
      pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
  pixel = colour >> 24 == 0xFF ? colour : over(pixel, colour);
}

PlacedImage Raster::image() const {
  int left = width_, right = 0, top = height_, bottom = 0;
  for (int row = 0; row < height_; ++row) {
    const auto begin = pixels_.begin() + static_cast<std::ptrdiff_t>(row) * width_, end = begin + width_;
    const auto first = std::find_if(begin, end, [](std::uint32_t pixel) { return pixel != 0; });
    if (first == end) continue;
    const auto last = std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(begin),
                                   [](std::uint32_t pixel) { return pixel != 0; });
    left = std::min(left, static_cast<int>(first - begin));
    right = std::max(right, static_cast<int>(last.base() - begin));
    top = std::min(top, row);
    bottom = row + 1;
  }
  if (right <= left) return {};
  PlacedImage placed{
      {right - left, bottom - top, {}},
      (1 / kPixelsPerUnit) * Point{static_cast<double>(left), static_cast<double>(top)},
      (1 / kPixelsPerUnit) * Point{static_cast<double>(right - left), static_cast<double>(bottom - top)}};
  for (int row = top; row < bottom; ++row) {
    const auto begin = pixels_.begin() + static_cast<std::ptrdiff_t>(row) * width_;
    placed.image.pixels.insert(placed.image.pixels.end(), begin + left, begin + right);
  }
  return placed;
}

}  // namespace keyblock::report
