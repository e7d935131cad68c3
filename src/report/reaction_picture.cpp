// One chart below a title, its plateaus as sentences at the foot.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/reaction_picture.hpp"

#include <fmt/format.h>

#include <cmath>

#include "problem/units/measure.hpp"
#include "report/drawing/chart.hpp"
#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kChartHeight = 366;
constexpr double kChartTop = 50;
constexpr double kLine = 20;

}  // namespace

std::string reaction_picture(const std::string& title, const std::vector<ReactionCurve>& curves, const Units& units) {
  std::vector<Curve> drawn;
  std::vector<std::string> sentences;
  const std::string unit =
      is_declared(measures::kForce, units) ? fmt::format(" {}", unit_of(measures::kForce, units)) : std::string();
  for (const ReactionCurve& curve : curves) {
    Curve& line = drawn.emplace_back();
    line.label = fmt::format("displacement {}, reaction {}", curve.number + 1, curve.component);
    for (std::size_t i = 0; i < curve.driven.size(); ++i) {
      line.x.push_back(curve.driven[i]);
      line.y.push_back(std::abs(curve.reaction[i]));
    }
    if (const auto first = plateau_of(curve))
      sentences.push_back(fmt::format("displacement {}: the reaction stays at {:.5g}{} since step {}", curve.number + 1,
                                      std::abs(curve.reaction.back()), unit, curve.steps[*first]));
  }
  SvgPage page(kPageWidth, kChartTop + kChartHeight + 18 + kLine * static_cast<double>(sentences.size()));
  page.text({kMargin, 28}, title, {.size = 17, .bold = true});
  if (has_points(drawn))
    draw_chart(page, {kMargin, kChartTop}, {kRoom, kChartHeight}, drawn,
               {{"displacement", measures::kLength, units}, {"reaction", measures::kForce, units}});
  for (std::size_t i = 0; i < sentences.size(); ++i)
    page.text({kMargin, kChartTop + kChartHeight + 16 + kLine * static_cast<double>(i)}, sentences[i], {.size = 13});
  return page.str();
}

}  // namespace keyblock::report
