// One chart below a title.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/energy_picture.hpp"

#include <algorithm>
#include <functional>
#include <vector>

#include "problem/units/measure.hpp"
#include "report/drawing/chart.hpp"

namespace keyblock::report {
namespace {

constexpr double kPageWidth = 900;
constexpr double kPageHeight = 430;
constexpr double kMargin = 30;
constexpr double kChartTop = 50;

using Energy = std::function<double(const LedgerRow&)>;

Curve curve_of(const char* label, const Ledger& ledger, const Energy& energy) {
  Curve curve;
  curve.label = label;
  for (const LedgerRow& row : ledger.rows) {
    curve.x.push_back(row.time);
    curve.y.push_back(energy(row));
  }
  return curve;
}

std::vector<Curve> curves_of(const Ledger& ledger) {
  std::vector<Curve> curves;
  const auto add = [&](const char* label, const Energy& energy) {
    Curve curve = curve_of(label, ledger, energy);
    const bool is_zero = std::ranges::all_of(curve.y, [](double y) { return y == 0; });
    if (!is_zero) curves.push_back(std::move(curve));
  };
  if (ledger.rows.empty()) return curves;
  const double first = ledger.rows.front().stored.gravity;
  add("kinetic", [](const LedgerRow& row) { return row.stored.kinetic; });
  add("strain", [](const LedgerRow& row) { return row.stored.strain; });
  add("contact springs", [](const LedgerRow& row) { return row.stored.contact; });
  add("gravity released", [first](const LedgerRow& row) { return first - row.stored.gravity; });
  add("work of loads", [](const LedgerRow& row) { return row.flow.external; });
  add("dissipated", [](const LedgerRow& row) { return row.flow.lost(); });
  return curves;
}

}  // namespace

std::string energy_picture(const std::string& title, const Ledger& ledger, const Units& units) {
  SvgPage page(kPageWidth, kPageHeight);
  page.text({kMargin, 28}, title, {.size = 17, .bold = true});
  const std::vector<Curve> curves = curves_of(ledger);
  if (has_points(curves))
    draw_chart(page, {kMargin, kChartTop}, {kPageWidth - 2 * kMargin, kPageHeight - kChartTop - 14}, curves,
               {with_unit("time", measures::kTime, units), with_unit("energy", measures::kEnergy, units)});
  return page.str();
}

}  // namespace keyblock::report
