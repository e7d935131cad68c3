// Crosses that keep their distance on the page; see stress_crosses.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/stress_crosses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "report/drawing/colours.hpp"
#include "report/drawing/ticks.hpp"
#include "result/extremes.hpp"

namespace keyblock::report {
namespace {

constexpr double kSquare = 20;       // page units: crosses stand no nearer to each other
constexpr double kLeastLength = 20;  // page units, of the longest line; longer where few crosses have much room
constexpr double kMostLength = 44;
constexpr double kOfRoom = 0.8;
constexpr double kShown = 0.98;  // share of the crosses that are drawn as long as they should be
constexpr double kLineWidth = 1.1;

struct Cross {
  Point middle;  ///< on the page
  std::pair<double, double> stresses;
  double angle = 0;  ///< of the second, the greater one, from the x axis to the left, rad
};

std::string_view colour_of(double stress) {
  return stress > 0 ? kTensionColour : kCompressionColour;
}

double greatest(const std::pair<double, double>& stresses) {
  return std::max(std::abs(stresses.first), std::abs(stresses.second));
}

/// Returns the crosses of elements in their order, of those that have room.
std::vector<Cross> crosses_of(const PageMap& map, const FieldFrame& field, const CornerPlace& place) {
  std::vector<Cross> crosses;
  std::map<std::pair<long, long>, std::vector<Point>> taken;  // by squares as large as the distance that is kept
  const auto has_room = [&](Point at, long column, long row) {
    for (long c = column - 1; c <= column + 1; ++c)
      for (long r = row - 1; r <= row + 1; ++r)
        if (const auto found = taken.find({c, r}); found != taken.end())
          for (const Point other : found->second)
            if (distance(at, other) < kSquare) return false;
    return true;
  };
  for (const FieldElement& element : field.elements) {
    const Point middle = map(place(element.middle));
    if (!std::isfinite(middle.x) || !std::isfinite(middle.y)) continue;
    const long column = std::lround(middle.x / kSquare), row = std::lround(middle.y / kSquare);
    if (!has_room(middle, column, row)) continue;
    taken[{column, row}].push_back(middle);
    crosses.push_back({middle, principal(element.middle.stress), principal_angle(element.middle.stress)});
  }
  return crosses;
}

/// Returns the amount that only the greatest few exceed.
double all_but_few(std::vector<double> amounts) {
  if (amounts.empty()) return 0;
  const auto at = static_cast<std::ptrdiff_t>(kShown * static_cast<double>(amounts.size() - 1));
  std::ranges::nth_element(amounts, amounts.begin() + at);
  return std::isfinite(amounts[static_cast<std::size_t>(at)]) ? amounts[static_cast<std::size_t>(at)] : 0;
}

double longest_of(const PageMap& map, std::size_t crosses) {
  const double room = std::sqrt(map.size().x * map.size().y / static_cast<double>(crosses));
  return std::clamp(kOfRoom * room, kLeastLength, kMostLength);
}

}  // namespace

double common_stress(const FieldFrame& field) {
  std::vector<double> amounts;
  for (const FieldElement& element : field.elements) amounts.push_back(greatest(principal(element.middle.stress)));
  return all_but_few(std::move(amounts));
}

CrossScale draw_crosses(SvgPage& page, const PageMap& map, const FieldFrame& field, const CornerPlace& place,
                        double most) {
  const std::vector<Cross> crosses = crosses_of(map, field, place);
  if (most == 0) {
    std::vector<double> amounts;
    for (const Cross& cross : crosses) amounts.push_back(greatest(cross.stresses));
    most = all_but_few(std::move(amounts));
  }
  if (!(most > 0)) return {};
  const double longest = longest_of(map, crosses.size());
  for (const Cross& cross : crosses)
    for (const auto& [stress, angle] :
         {std::pair{cross.stresses.second, cross.angle}, {cross.stresses.first, cross.angle + M_PI / 2}}) {
      const double length = longest * std::min(1.0, std::abs(stress) / most);
      const Point half{length / 2 * std::cos(angle), -length / 2 * std::sin(angle)};
      page.line(cross.middle - half, cross.middle + half, {.stroke = colour_of(stress), .stroke_width = kLineWidth});
    }
  const double sample = round_down(most);
  const bool are_cut =
      std::ranges::any_of(crosses, [&](const Cross& cross) { return greatest(cross.stresses) > most; });
  return {sample, longest * sample / most, are_cut};
}

void draw_cross_legend(SvgPage& page, Point corner, const CrossScale& scale, const Units& units) {
  const Scaled shown = readable({"", measures::kStress, units}, scale.sample);
  double y = corner.y;
  for (const auto& [colour, words] : {std::pair{kCompressionColour, "compression"}, {kTensionColour, "tension"}}) {
    page.line({corner.x, y}, {corner.x + kLeastLength, y}, {.stroke = colour, .stroke_width = 2});
    page.text({corner.x + kLeastLength + 6, y + 4}, words, {.size = 11});
    y += 18;
  }
  y += 10;
  page.line({corner.x, y}, {corner.x + scale.length, y}, {.stroke = "#222222", .stroke_width = kLineWidth});
  page.text({corner.x + std::max(kLeastLength, scale.length) + 6, y + 4},
            fmt::format("{:g}{}{}", shown.factor * scale.sample, shown.unit.empty() ? "" : " ", shown.unit),
            {.size = 11});
  if (scale.are_cut) page.text({corner.x, y + 22}, "longest are cut", {.size = 11});
}

}  // namespace keyblock::report
