// A picture of blocks as cut: materials, joints, points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/blocks.hpp"
#include "problem/run_choices.hpp"
#include "report/drawing/block_numbers.hpp"

namespace keyblock::report {

/// An SVG document: blocks filled by material, edges coloured by joint material, fixed, loading and measured
/// points, bolts, a legend and a scale bar; with the numbers of all blocks where they are asked for.
std::string blocks_picture(const Blocks& blocks, const Units& units = {}, Numbers numbers = Numbers::none);

}  // namespace keyblock::report
