// One chart below a title.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/rock/element_picture.hpp"

#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kWidth = 700;
constexpr double kHeight = 460;
constexpr double kChartTop = 50;

}  // namespace

std::string element_picture(const std::string& title, const std::string& x_label, const std::vector<double>& x,
                            const std::string& y_label, const std::vector<double>& y) {
  return curves_picture(title, {x_label, y_label}, {{y_label, x, y}});
}

std::string curves_picture(const std::string& title, const AxisLabels& labels, const std::vector<Curve>& curves) {
  SvgPage page(kWidth, kHeight);
  page.text({kMargin, 28}, title, {.size = 17, .bold = true});
  if (has_points(curves))
    draw_chart(page, {kMargin, kChartTop}, {kWidth - 2 * kMargin, kHeight - kChartTop - 14}, curves, labels);
  return page.str();
}

}  // namespace keyblock::report
