// Writes SVG by hand: it is a page of text, and no package is needed for it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/printable.hpp"

namespace keyblock::report {
namespace {

bool is_finite(Point p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

bool are_finite(const std::vector<Point>& points) {
  return std::ranges::all_of(points, is_finite);
}

/// A page coordinate: hundredths are finer than any screen; fmt ignores the locale.
std::string page_number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string coordinates(const std::vector<Point>& points) {
  std::string text;
  for (Point p : points) {
    if (!text.empty()) text += ' ';
    text += fmt::format("{},{}", page_number(p.x), page_number(p.y));
  }
  return text;
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

}  // namespace

void SvgPage::polygon(const std::vector<std::vector<Point>>& loops, const Style& style) {
  std::string path;
  for (const std::vector<Point>& loop : loops) {
    if (loop.empty()) continue;
    if (!are_finite(loop)) return;
    path += fmt::format("M{}Z", coordinates(loop));
  }
  if (path.empty()) return;
  body_ += fmt::format("<path fill-rule=\"evenodd\" stroke-linejoin=\"round\" d=\"{}\"{}/>\n", path, attributes(style));
}

void SvgPage::polyline(const std::vector<Point>& points, const Style& style) {
  if (points.size() < 2 || !are_finite(points)) return;
  body_ +=
      fmt::format("<polyline stroke-linejoin=\"round\" points=\"{}\"{}/>\n", coordinates(points), attributes(style));
}

void SvgPage::line(Point from, Point to, const Style& style) {
  polyline({from, to}, style);
}

void SvgPage::circle(Point center, double radius, const Style& style) {
  if (!is_finite(center)) return;
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", page_number(center.x), page_number(center.y),
                       page_number(radius), attributes(style));
}

void SvgPage::rectangle(Point corner, double width, double height, const Style& style) {
  polygon(
      {{corner, {corner.x + width, corner.y}, {corner.x + width, corner.y + height}, {corner.x, corner.y + height}}},
      style);
}

void SvgPage::text(Point anchor, std::string_view words, const TextStyle& style) {
  if (!is_finite(anchor) || words.empty()) return;
  const std::string x = page_number(anchor.x);
  const std::string y = page_number(anchor.y);
  std::string extra;
  if (style.bold) extra += " font-weight=\"bold\"";
  if (style.turn_deg != 0) extra += fmt::format(" transform=\"rotate({} {} {})\"", page_number(style.turn_deg), x, y);
  body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n", x, y,
                       page_number(style.size), name_of(style.anchor), style.fill, extra, escape_xml(words));
}

void SvgPage::begin_group(std::string_view words) {
  body_ += fmt::format("<g><title>{}</title>\n", escape_xml(words));
}

void SvgPage::end_group() {
  body_ += "</g>\n";
}

std::string SvgPage::str() const {
  const std::string width = page_number(width_);
  const std::string height = page_number(height_);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n{2}</svg>\n",
      width, height, body_);
}

std::string escape_xml(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  for (char c : valid_utf8(text)) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        // Other control characters may not stand in XML 1.0 at all.
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\t' || c == '\n') safe += c;
    }
  }
  return safe;
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
