// Draws blocks as cut: materials, joints, points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/blocks.hpp"
#include "problem/run_choices.hpp"
#include "report/drawing/block_numbers.hpp"

namespace keyblock::report {

/// Returns an SVG document: blocks filled by material, edges coloured by joint material, fixed, loading and measured
/// points, bolts, a legend and a scale bar; with the numbers of all blocks if requested. Names of materials by
/// number, from 0.
std::string blocks_picture(const Blocks& blocks, const Units& units = {}, Numbers numbers = Numbers::none,
                           const std::vector<std::string>& rock_names = {},
                           const std::vector<std::string>& joint_names = {});

}  // namespace keyblock::report
