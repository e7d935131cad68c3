// Writes a small SVG page: shapes and text in page coordinates, with the map from the plane of blocks onto the page.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/point.hpp"
#include "report/drawing/raster.hpp"
#include "report/drawing/shape_text.hpp"

namespace keyblock::report {

/// Style of a shape; colours as in SVG.
struct Style {
  std::string_view fill = "none";
  std::string_view stroke = "none";
  double stroke_width = 1;
  std::string_view dash = {};  ///< lengths of dash and gap, e.g. "4 3"; empty for a full line
};

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 13;
  Anchor anchor = Anchor::start;
  std::string_view fill = "#222222";
  bool bold = false;
  double turn_deg = 0;  ///< clockwise on the page, about the anchor
};

/// Characters of the shapes of a layer, and of the raster that replaces them above that. The first is about 6,500
/// quadrilaterals of one style. A picture of three panels, each one large layer, stays below 2 MB.
inline constexpr std::size_t kMostShapeText = 400'000;
inline constexpr std::size_t kMostImageText = 600'000;

/// Collects shapes in drawing order; page coordinates run right and down from the top left corner. Shapes
/// with a coordinate that is not finite are left out.
class SvgPage {
 public:
  SvgPage(double width, double height) : width_(width), height_(height) {}

  /// Closed loops filled by the even-odd rule, so that inner loops are holes.
  void polygon(const std::vector<std::vector<Point>>& loops, const Style& style);
  void polyline(const std::vector<Point>& points, const Style& style);
  void line(Point from, Point to, const Style& style);
  void circle(Point center, double radius, const Style& style);
  void rectangle(Point corner, double width, double height, const Style& style);
  void text(Point anchor, std::string_view words, const TextStyle& style = {});

  /// Shapes until `end_group` show `words` where the pointer rests on them.
  void begin_group(std::string_view words);
  void end_group();

  /// Calls `draw()`, which draws many shapes on the page. They become a raster if their text exceeds
  /// `kMostShapeText`; see `Raster` for edges. Words drawn among them lie over them, and a raster has none. A layer
  /// within a layer is part of it. Colours are "none" or "#rrggbb"; others throw std::invalid_argument.
  template <class Draw>
  void layer(Draw draw) {
    begin_layer();
    draw();
    end_layer();
  }

  /// Returns the whole document.
  std::string str() const;

 private:
  struct Outline {
    std::vector<std::vector<Point>> loops;
    bool is_closed = false;
  };
  struct Layer {
    ShapeText shapes;  ///< as long as they are no raster
    ShapeText words;
    std::vector<std::pair<Outline, Ink>> kept;  ///< the same shapes
    std::optional<Raster> raster;
  };

  /// Style of the last shape in a raster.
  struct LastInk {
    std::string fill = "none", stroke = "none", dash = {};
    Ink ink = {};
  };

  bool is_raster() const { return layer_ && layer_->raster; }
  void add(std::string_view element, const Style& style, Outline&& outline);
  const Ink& ink(const Style& style);
  void begin_layer();
  void end_layer();

  double width_;
  double height_;
  ShapeText body_;
  std::optional<Layer> layer_;
  LastInk last_ink_;
  int depth_ = 0;
};

/// Returns a width that the text does not exceed in a common sans-serif face.
double text_width(std::string_view utf8, double size);

/// An upright rectangle that grows around points; empty until the first.
struct Box {
  Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  bool empty() const { return !(low.x <= high.x && low.y <= high.y); }
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  /// Points that are not finite are ignored.
  void include(Point p);
};

/// Maps a box of the plane (y up) onto the page (y down), as large as fits in `room`, both axes at one scale.
class PageMap {
 public:
  /// The drawing starts at the top left corner `corner`; see size() for what it takes of the room.
  PageMap(const Box& world, Point corner, Point room);

  Point operator()(Point p) const;
  std::vector<Point> operator()(const std::vector<Point>& points) const;
  std::vector<std::vector<Point>> operator()(const std::vector<std::vector<Point>>& loops) const;

  double scale() const { return scale_; }  ///< page units per unit of the plane
  Point size() const { return size_; }     ///< width and height on the page

 private:
  Box world_;
  Point corner_;
  double scale_ = 1;
  Point size_;
};

}  // namespace keyblock::report
