// A picture of how cracks went on: their path in the undeformed bodies, and what pulled at their tips on the way.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/run_choices.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"

namespace keyblock::report {

/// An SVG document: the bodies of the first frame with the paths of all tips, K_I and K_II of each over the length of
/// its crack, and, where cracks grow, the factor of the loads.
std::string crack_picture(const std::string& title, const Frame& start, const History& history,
                          const Units& units = {});

}  // namespace keyblock::report
