// A picture of a single element's answer: stress over strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace keyblock::report {

/// An SVG document with one curve, its axes named as given.
std::string element_picture(const std::string& title, const std::string& x_label, const std::vector<double>& x,
                            const std::string& y_label, const std::vector<double>& y);

}  // namespace keyblock::report
