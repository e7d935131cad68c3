// Writes one line per crack tip; see tips_csv.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/tips_csv.hpp"

#include <fmt/format.h>

#include <numbers>

#include "formats/tables/run_tables.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock::formats {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

void append(std::string& text, bool is_there, double value) {
  text += ',';
  if (is_there) text += format_real(value);
}

void append_tip(std::string& text, const TipState& tip, std::size_t number) {
  text += fmt::format(",{},{},{}", number + 1, tip.crack + 1, tip.at_end ? 2 : 1);
  for (const double value : {tip.at.x, tip.at.y, tip.length}) append(text, true, value);
  for (const double value : {tip.mode_1, tip.mode_2, tip.energy_release, tip.equivalent, tip.kink * kDegrees})
    append(text, tip.has_room, value);
  append(text, tip.toughness > 0, tip.toughness);
  text += fmt::format(",{},{}\n", tip.goes_on ? 1 : 0, tip.is_shear ? "shear" : "tension");
}

}  // namespace

std::string tips_csv(const History& history, const Units& units) {
  std::string text;
  for (const HistoryRow& row : history.rows)
    for (std::size_t i = 0; i < row.tips.size(); ++i) {
      text += fmt::format("{},{},{}", row.step, format_real(row.time), format_real(row.load_factor));
      append_tip(text, row.tips[i], i);
    }
  if (text.empty()) return text;
  return headings(kTipsTable, units) + '\n' + text;
}

}  // namespace keyblock::formats
