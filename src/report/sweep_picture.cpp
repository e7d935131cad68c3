// Cells as tall as they are wide up to a width that numbers need.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/drawing/colours.hpp"
#include "report/drawing/svg.hpp"
#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kCellWidth = 104;
constexpr double kCellHeight = 58;
constexpr double kTop = 88;
constexpr double kRowHeading = 150;
constexpr double kBottom = 74;
constexpr double kBarWidth = 110;
constexpr double kLeastSpan = 1;  // decades: nearly equal errors do not span all colours

/// Colours from dark violet, the least error, to yellow; lightness alone shows the order.
struct LogColours {
  double low = 0;  ///< logarithms
  double high = 1;

  /// The least error is dark.
  Channels at(double logarithm) const { return colour_at(palette::kViridis, (logarithm - low) / (high - low)); }
};

std::string_view ink_on(const Channels& colour) {
  return 0.3 * colour[0] + 0.6 * colour[1] + 0.1 * colour[2] < 130 ? "#ffffff" : "#222222";
}

LogColours colours_of(const SweepPicture& picture) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const auto& row : picture.cells)
    for (const SweptCell& cell : row) {
      if (!std::isfinite(cell.error)) continue;
      least = std::min(least, std::log10(cell.error));
      most = std::max(most, std::log10(cell.error));
    }
  if (!(least <= most)) return {};
  return {least, std::max(most, least + kLeastSpan)};
}

void draw_cell(SvgPage& page, Point corner, const SweptCell& cell, const LogColours& colours) {
  const Point middle = corner + Point{kCellWidth / 2, kCellHeight / 2 + 5};
  page.begin_group(cell.details);
  if (std::isfinite(cell.error)) {
    const Channels colour = colours.at(std::log10(cell.error));
    page.rectangle(corner, kCellWidth, kCellHeight, {.fill = hex(colour), .stroke = "#ffffff", .stroke_width = 1});
    page.text(middle, fmt::format("{:.2g}", cell.error),
              {.size = 14, .anchor = Anchor::middle, .fill = ink_on(colour)});
  } else {
    page.rectangle(corner, kCellWidth, kCellHeight, {.fill = "#eeeeee", .stroke = "#ffffff", .stroke_width = 1});
    const Style cross{.stroke = "#c8c8c8", .stroke_width = 1.2};
    page.line(corner, corner + Point{kCellWidth, kCellHeight}, cross);
    page.line(corner + Point{0, kCellHeight}, corner + Point{kCellWidth, 0}, cross);
    page.text(middle, cell.words, {.size = 13, .anchor = Anchor::middle, .fill = "#9c1c1c", .bold = true});
  }
  page.end_group();
}

void draw_bar(SvgPage& page, Point corner, double height, const LogColours& colours) {
  constexpr int kSteps = 48;
  page.text({corner.x, corner.y - 10}, "relative error", {.size = 12, .bold = true});
  for (int i = 0; i < kSteps; ++i) {
    const double logarithm = std::lerp(colours.high, colours.low, (i + 0.5) / kSteps);
    page.rectangle({corner.x, corner.y + height * i / kSteps}, 14, height / kSteps + 0.4,
                   {.fill = hex(colours.at(logarithm))});
  }
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    page.text({corner.x + 20, corner.y + share * height + 4},
              fmt::format("{:.1e}", std::pow(10, std::lerp(colours.high, colours.low, share))), {.size = 11});
}

}  // namespace

std::string sweep_picture(const SweepPicture& picture) {
  const double across = kCellWidth * static_cast<double>(picture.columns.size());
  const double down = kCellHeight * static_cast<double>(picture.rows.size());
  const double wanted = std::max(kMargin + kRowHeading + across + kBarWidth,
                                 std::max(text_width(picture.title, 17), text_width(picture.subtitle, 12)));
  SvgPage page(wanted + 2 * kMargin, kTop + down + kBottom);
  page.text({kMargin, 28}, picture.title, {.size = 17, .bold = true});
  page.text({kMargin, 48}, picture.subtitle, {.size = 12});
  const Point corner{kMargin + kRowHeading, kTop};
  const LogColours colours = colours_of(picture);
  for (std::size_t r = 0; r < picture.cells.size(); ++r)
    for (std::size_t c = 0; c < picture.cells[r].size(); ++c)
      draw_cell(page, corner + Point{kCellWidth * static_cast<double>(c), kCellHeight * static_cast<double>(r)},
                picture.cells[r][c], colours);
  for (std::size_t r = 0; r < picture.rows.size(); ++r)
    page.text({corner.x - 8, corner.y + kCellHeight * (static_cast<double>(r) + 0.5) + 5}, picture.rows[r],
              {.size = 13, .anchor = Anchor::end});
  for (std::size_t c = 0; c < picture.columns.size(); ++c)
    page.text({corner.x + kCellWidth * (static_cast<double>(c) + 0.5), corner.y + down + 20}, picture.columns[c],
              {.size = 13, .anchor = Anchor::middle});
  page.text({corner.x + across / 2, corner.y + down + 46}, picture.column_label,
            {.size = 13, .anchor = Anchor::middle});
  page.text({kMargin, corner.y - 12}, picture.row_label, {.size = 13});
  draw_bar(page, {corner.x + across + 24, corner.y}, down, colours);
  return page.str();
}

}  // namespace keyblock::report
