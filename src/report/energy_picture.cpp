// One chart below a title, and more of the energies that are small in it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/energy_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "problem/units/measure.hpp"
#include "report/drawing/chart.hpp"
#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kPageHeight = 430;
constexpr double kChartTop = 50;
constexpr double kSmallChartHeight = 320;
constexpr double kSmallChartTitle = 26;
constexpr double kSmall = 0.05;    // of the greatest energy of a panel: a curve that cannot be read in it
constexpr double kNothing = 1e-6;  // of the greatest energy of all: round-off, or as good as nothing
constexpr std::size_t kMostPanels = 3;

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
  add("changes of the scene", [](const LedgerRow& row) { return row.flow.change; });
  return curves;
}

double greatest(const Curve& curve) {
  double most = 0;
  for (const double y : curve.y)
    if (std::isfinite(y)) most = std::max(most, std::abs(y));
  return most;
}

double greatest(const std::vector<Curve>& curves) {
  double most = 0;
  for (const Curve& curve : curves) most = std::max(most, greatest(curve));
  return most;
}

/// Returns whether the curve changes by more than round-off, which a scale of its own would show.
bool changes(const Curve& curve) {
  const auto [low, high] = std::ranges::minmax(curve.y);
  return high - low > kNothing * greatest(curve);
}

/// All, then those of the panel before that hug zero in it, in their colours.
std::vector<std::vector<Curve>> panels_of(std::vector<Curve> curves) {
  const double most = greatest(curves);
  for (std::size_t i = 0; i < curves.size(); ++i) curves[i].colour = i;
  std::vector<std::vector<Curve>> panels{std::move(curves)};
  while (panels.size() < kMostPanels) {
    std::vector<Curve> small;
    for (const Curve& curve : panels.back())
      if (greatest(curve) < kSmall * greatest(panels.back()) && greatest(curve) > kNothing * most)
        small.push_back(curve);
    if (std::ranges::none_of(small, changes)) break;
    panels.push_back(std::move(small));
  }
  return panels;
}

}  // namespace

std::string energy_picture(const std::string& title, const Ledger& ledger, const Units& units) {
  const std::vector<std::vector<Curve>> panels = panels_of(curves_of(ledger));
  const double more = static_cast<double>(panels.size() - 1) * (kSmallChartTitle + kSmallChartHeight);
  SvgPage page(kPageWidth, kPageHeight + more);
  page.text({kMargin, 28}, title, {.size = 17, .bold = true});
  const AxisLabels labels{{"time", measures::kTime, units}, {"energy", measures::kEnergy, units}};
  if (has_points(panels.front()))
    draw_chart(page, {kMargin, kChartTop}, {kRoom, kPageHeight - kChartTop - 14}, panels.front(), labels);
  double top = kPageHeight;
  for (std::size_t i = 1; i < panels.size(); ++i, top += kSmallChartTitle + kSmallChartHeight) {
    page.text({kMargin, top + 10},
              fmt::format("of these, those below {:g} % of the greatest, to a scale of their own", 100 * kSmall));
    draw_chart(page, {kMargin, top + kSmallChartTitle}, {kRoom, kSmallChartHeight - 14}, panels[i], labels);
  }
  return page.str();
}

}  // namespace keyblock::report
