// Writes SVG as text; a layer begins as text and becomes a raster once its text is too long.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "base/printable.hpp"

namespace keyblock::report {
namespace {

bool is_finite(Point p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

bool are_finite(const std::vector<Point>& points) {
  return std::ranges::all_of(points, is_finite);
}

std::string attributes(const Style& style) {
  std::string text = fmt::format(" fill=\"{}\"", style.fill);
  if (style.stroke == "none") return text;
  text += fmt::format(" stroke=\"{}\" stroke-width=\"{}\"", style.stroke, page_number(style.stroke_width));
  if (!style.dash.empty()) text += fmt::format(" stroke-dasharray=\"{}\"", style.dash);
  return text;
}

std::string_view name_of(Anchor anchor) {
  switch (anchor) {
    case Anchor::start:
      return "start";
    case Anchor::middle:
      return "middle";
    case Anchor::end:
      return "end";
  }
  return "start";
}

/// A circle in a raster layer.
std::vector<Point> corners_of(Point center, double radius) {
  constexpr int kCorners = 16;
  std::vector<Point> corners;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * M_PI * i / kCorners;
    corners.push_back(center + radius * Point{std::cos(angle), std::sin(angle)});
  }
  return corners;
}

/// Returns an opaque colour; 0 for "none".
std::uint32_t colour_of(std::string_view text) {
  if (text == "none") return 0;
  std::uint32_t colour = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), colour, 16);
  if (text.size() != 7 || text[0] != '#' || error != std::errc() || end != text.data() + text.size())
    throw std::invalid_argument(fmt::format("expected a colour #rrggbb in a layer, found {}", text));
  return colour | 0xFF000000;
}

Ink ink_of(const Style& style) {
  Ink ink{.fill = colour_of(style.fill), .stroke = colour_of(style.stroke), .width = style.stroke_width};
  if (style.dash.empty()) return ink;
  const std::size_t space = style.dash.find(' ');
  ink.dash = std::stod(std::string(style.dash));
  ink.gap = space == std::string_view::npos ? ink.dash : std::stod(std::string(style.dash.substr(space)));
  return ink;
}

/// Encodes a raster, whose resolution is halved until its text is short enough.
std::string image_element(const PlacedImage& placed) {
  if (placed.image.pixels.empty()) return {};
  std::string data = base64(png_of(placed.image));
  for (Image image = placed.image; data.size() > kMostImageText && image.pixels.size() > 1;) {
    image = halved(image);
    data = base64(png_of(image));
  }
  return fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "href=\"data:image/png;base64,{}\"/>\n",
      page_number(placed.corner.x), page_number(placed.corner.y), page_number(placed.size.x),
      page_number(placed.size.y), data);
}

}  // namespace

void SvgPage::polygon(const std::vector<std::vector<Point>>& loops, const Style& style) {
  if (!std::ranges::all_of(loops, are_finite) || std::ranges::all_of(loops, &std::vector<Point>::empty)) return;
  if (is_raster()) return layer_->raster->draw(loops, true, ink(style));
  std::string element = "<path d=\"";
  for (const std::vector<Point>& loop : loops)
    if (!loop.empty()) element.append("M").append(coordinates(loop)).append("Z");
  add(element += '"', style, {loops, true});
}

void SvgPage::polyline(const std::vector<Point>& points, const Style& style) {
  if (points.size() < 2 || !are_finite(points)) return;
  if (is_raster()) return layer_->raster->draw_line(points, ink(style));
  add(fmt::format("<polyline points=\"{}\"", coordinates(points)), style, {{points}, false});
}

void SvgPage::line(Point from, Point to, const Style& style) {
  if (is_raster() && is_finite(from) && is_finite(to)) {
    const std::array ends{from, to};
    return layer_->raster->draw_line(ends, ink(style));
  }
  polyline({from, to}, style);
}

void SvgPage::circle(Point center, double radius, const Style& style) {
  if (!is_finite(center)) return;
  if (is_raster()) return layer_->raster->draw({corners_of(center, radius)}, true, ink(style));
  add(fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"", page_number(center.x), page_number(center.y),
                  page_number(radius)),
      style, {{corners_of(center, radius)}, true});
}

void SvgPage::rectangle(Point corner, double width, double height, const Style& style) {
  polygon(
      {{corner, {corner.x + width, corner.y}, {corner.x + width, corner.y + height}, {corner.x, corner.y + height}}},
      style);
}

void SvgPage::text(Point anchor, std::string_view words, const TextStyle& style) {
  if (!is_finite(anchor) || words.empty() || is_raster()) return;
  const std::string x = page_number(anchor.x);
  const std::string y = page_number(anchor.y);
  std::string look = fmt::format(" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"", page_number(style.size),
                                 name_of(style.anchor), style.fill);
  if (style.bold) look += " font-weight=\"bold\"";
  std::string element = fmt::format("<text x=\"{}\" y=\"{}\"", x, y);
  if (style.turn_deg != 0) element += fmt::format(" transform=\"rotate({} {} {})\"", page_number(style.turn_deg), x, y);
  (layer_ ? layer_->words : body_).add(element, look, fmt::format(">{}</text>", escape_xml(words)));
}

void SvgPage::begin_group(std::string_view words) {
  body_.add_plain(fmt::format("<g><title>{}</title>\n", escape_xml(words)));
}

void SvgPage::end_group() {
  body_.add_plain("</g>\n");
}

void SvgPage::add(std::string_view element, const Style& style, Outline&& outline) {
  if (!layer_) return body_.add(element, attributes(style));
  layer_->shapes.add(element, attributes(style));
  layer_->kept.emplace_back(std::move(outline), ink_of(style));
  if (layer_->shapes.size() <= kMostShapeText) return;
  layer_->raster.emplace(width_, height_);
  for (const auto& [kept, ink] : layer_->kept) layer_->raster->draw(kept.loops, kept.is_closed, ink);
  layer_->kept = {};
}

// Many shapes in turn have one style.
const Ink& SvgPage::ink(const Style& style) {
  LastInk& last = last_ink_;
  if (style.fill != last.fill || style.stroke != last.stroke || style.dash != last.dash ||
      style.stroke_width != last.ink.width)
    last = {std::string(style.fill), std::string(style.stroke), std::string(style.dash), ink_of(style)};
  return last.ink;
}

void SvgPage::begin_layer() {
  if (depth_++ == 0) layer_.emplace();
}

void SvgPage::end_layer() {
  if (--depth_ > 0) return;
  Layer layer = *std::move(layer_);
  layer_.reset();
  if (layer.raster) return body_.add_plain(image_element(layer.raster->image()));
  body_.append(std::move(layer.shapes));
  body_.append(std::move(layer.words));
}

std::string SvgPage::str() const {
  const std::string width = page_number(width_);
  const std::string height = page_number(height_);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" fill-rule=\"evenodd\" stroke-linejoin=\"round\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n{2}</svg>\n",
      width, height, body_.str());
}

double text_width(std::string_view utf8, double size) {
  // Bytes 10xxxxxx continue a character. 0.64 em is the mean of DejaVu Sans, the widest face named.
  const auto characters =
      std::ranges::count_if(utf8, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  return 0.64 * size * static_cast<double>(characters);
}

void Box::include(Point p) {
  if (!is_finite(p)) return;
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

PageMap::PageMap(const Box& world, Point corner, Point room) : world_(world), corner_(corner) {
  if (world_.empty()) world_ = {{0, 0}, {1, 1}};
  const double across = world_.width() > 0 ? room.x / world_.width() : std::numeric_limits<double>::max();
  const double upward = world_.height() > 0 ? room.y / world_.height() : std::numeric_limits<double>::max();
  scale_ = std::min(across, upward);
  if (scale_ == std::numeric_limits<double>::max()) scale_ = 1;  // a single point has no scale
  size_ = {scale_ * world_.width(), scale_ * world_.height()};
}

Point PageMap::operator()(Point p) const {
  return {corner_.x + scale_ * (p.x - world_.low.x), corner_.y + scale_ * (world_.high.y - p.y)};
}

std::vector<Point> PageMap::operator()(const std::vector<Point>& points) const {
  std::vector<Point> mapped;
  mapped.reserve(points.size());
  std::ranges::transform(points, std::back_inserter(mapped), [this](Point p) { return (*this)(p); });
  return mapped;
}

std::vector<std::vector<Point>> PageMap::operator()(const std::vector<std::vector<Point>>& loops) const {
  std::vector<std::vector<Point>> mapped;
  mapped.reserve(loops.size());
  for (const std::vector<Point>& loop : loops) mapped.push_back((*this)(loop));
  return mapped;
}

}  // namespace keyblock::report
