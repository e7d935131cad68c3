// Chooses the arrangement by the width of the page and the shape of the body.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/field_panels.hpp"

#include <algorithm>
#include <utility>

#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kGap = 18;
constexpr double kCaption = 24;
constexpr double kBarWidth = 92;  // colour bar with its numbers
constexpr double kTall = 1.25;    // height over width
constexpr double kTallHeight = 460;
constexpr double kSmallHeight = 240;
constexpr double kFieldHeight = 420;
constexpr double kLeastSmall = 60;
constexpr double kTitle = 17;
constexpr double kNarrowTitle = 13;
constexpr double kLine = 1.3;     // height of a line over that of its letters
constexpr double kBaseline = 28;  // of the first line

/// Places the panels side by side.
void place_in_row(Panels& panels, double room, double top) {
  panels.rooms.fill({(room - kBarWidth - 2 * kGap) / 3, kTallHeight});
  for (std::size_t k = 0; k < 3; ++k)
    panels.corners[k] = {kMargin + static_cast<double>(k) * (panels.rooms[k].x + kGap), top};
}

/// Places both meshes one above the other, and the field of their common height beside them.
void place_in_columns(Panels& panels, double room, double top, double height_over_width) {
  const double between = (kGap + kCaption) / height_over_width;
  const double small = std::max(kLeastSmall, (room - kBarWidth - kGap - between) / 3);
  const Point size{small, small * height_over_width};
  panels.rooms = {size, size, Point{2 * small + between, 2 * size.y + kGap + kCaption}};
  panels.corners = {Point{kMargin, top}, Point{kMargin, top + size.y + kGap + kCaption},
                    Point{kMargin + small + kGap, top}};
}

/// Returns the title in lines that fit the page, broken at its commas.
std::vector<std::string> title_lines(const std::string& title, double room, double size) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t at = 0; at < title.size();) {
    const std::size_t comma = title.find(", ", at);
    const std::string part = title.substr(at, comma == std::string::npos ? comma : comma - at);
    const std::string longer = line.empty() ? part : line + ", " + part;
    if (!line.empty() && text_width(longer, size) > room)
      lines.push_back(std::exchange(line, part));
    else
      line = longer;
    at = comma == std::string::npos ? title.size() : comma + 2;
  }
  lines.push_back(line);
  return lines;
}

}  // namespace

Panels place_panels(const Box& box, double wide, double below_title) {
  Panels panels;
  const double top = below_title + kCaption;
  const double room = wide - 2 * kMargin;
  const double height_over_width = box.width() > 0 ? box.height() / box.width() : 0;
  if (wide < kLeastForThree) {
    panels.rooms = {Point{}, Point{}, Point{room - kBarWidth, kFieldHeight}};
    panels.corners.fill({kMargin, top});
  } else if (height_over_width > kTall) {
    place_in_row(panels, room, top);
  } else if (height_over_width > kFieldHeight / (room - kBarWidth)) {
    place_in_columns(panels, room, top, height_over_width);
  } else {
    panels.rooms = {Point{(room - kGap) / 2, kSmallHeight}, Point{(room - kGap) / 2, kSmallHeight},
                    Point{room - kBarWidth, kFieldHeight}};
    const double below = top + PageMap(box, {}, panels.rooms[0]).size().y + kGap + kCaption;
    panels.corners = {Point{kMargin, top}, Point{kMargin + panels.rooms[0].x + kGap, top}, Point{kMargin, below}};
  }
  panels.bottom = panels.corners[2].y + PageMap(box, {}, panels.rooms[2]).size().y + 12;
  return panels;
}

PageTitle title_of(const std::string& words, double room, bool is_narrow) {
  PageTitle title{{}, is_narrow ? kNarrowTitle : kTitle, 0};
  title.lines = title_lines(words, room, title.size);
  title.bottom = kTitleHeight + kLine * title.size * static_cast<double>(title.lines.size() - 1);
  return title;
}

void draw_title(SvgPage& page, const PageTitle& title) {
  double y = kBaseline;
  for (const std::string& line : title.lines) {
    page.text({kMargin, y}, line, {.size = title.size, .bold = true});
    y += kLine * title.size;
  }
}

}  // namespace keyblock::report
