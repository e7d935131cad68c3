// Draws tests of rock: stress over strain, one curve or several.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "report/drawing/chart.hpp"

namespace keyblock::report {

/// Returns an SVG document with one curve, its axes named as given.
std::string element_picture(const std::string& title, const std::string& x_label, const std::vector<double>& x,
                            const std::string& y_label, const std::vector<double>& y);

/// Does the same for several curves.
std::string curves_picture(const std::string& title, const AxisLabels& labels, const std::vector<Curve>& curves);

}  // namespace keyblock::report
