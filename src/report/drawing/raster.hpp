// Draws areas and edges as pixels: the raster layer of a page with too many shapes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"
#include "report/drawing/png.hpp"

namespace keyblock::report {

inline constexpr double kPixelsPerUnit = 2;  ///< of the page

/// A style in numbers; colours are 0xAARRGGBB, 0 for none.
struct Ink {
  std::uint32_t fill = 0;
  std::uint32_t stroke = 0;
  double width = 0;  ///< of the stroke, page units
  double dash = 0;   ///< page units; 0: a full line
  double gap = 0;
};

/// A part of the page as pixels, and its place there.
struct PlacedImage {
  Image image;
  Point corner;  ///< page units
  Point size;
};

/// The pixels of a page, transparent at first.
class Raster {
 public:
  Raster(double width, double height);

  /// Draws a shape with corners on the page. Areas follow the even-odd rule: a pixel is inside if its centre is. An
  /// edge thinner than a pixel is one pixel wide; its opacity is its width in pixels. Unless it is dashed, it fades out
  /// if its closed shape is smaller than eight pixels, and is left out below four. An edge of the colour of its area is
  /// left out too.
  void draw(const std::vector<std::vector<Point>>& loops, bool is_closed, const Ink& ink);

  /// Draws an open line with corners on the page, in the same way.
  void draw_line(std::span<const Point> points, const Ink& ink);

  /// Returns the drawn pixels, cut to their bounds.
  PlacedImage image() const;

 private:
  struct Crossing {
    int row = 0;
    double x = 0;
  };

  void fill(const std::vector<std::vector<Point>>& loops, std::uint32_t colour);
  void edges(std::span<const Point> loop, bool is_closed, const Ink& ink, std::uint32_t colour);
  void dashes(Point from, Point to, const Ink& ink, std::uint32_t colour, double& along);
  void piece(Point from, Point to, const Ink& ink, std::uint32_t colour);
  void thin_line(Point from, Point to, std::uint32_t colour);
  void blend(int column, int row, std::uint32_t colour);

  int width_;
  int height_;
  std::vector<std::uint32_t> pixels_;
  std::vector<Crossing> crossings_;
  std::vector<std::vector<Point>> quad_;
};

}  // namespace keyblock::report
