// A picture of blocks as cut: materials, joints, points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/blocks.hpp"
#include "problem/run_choices.hpp"

namespace keyblock::report {

/// An SVG document: blocks filled by material, edges coloured by joint material, fixed, loading and measured
/// points, bolts, a legend and a scale bar.
std::string blocks_picture(const Blocks& blocks, const Units& units = {});

}  // namespace keyblock::report
