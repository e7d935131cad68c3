// Warns before the first step: slivers, blocks without support, springs too stiff for the step, implausible units.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/problem.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Returns named warnings with numbers and places, in the units of the input. Names: `slivers`,
/// `block_outside_outline`, `point_outside_its_block`, `free_blocks`, `unheld_blocks`, `unsupported_blocks`,
/// `block_cannot_bend`, `springs_stiff_for_step`, `toe_wedged`, those of `implausible_units`, `springs_unresolved`,
/// `strain_damping_takes_rebound`. NMM bodies are checked only for units and impacts.
Warnings look_ahead(const Problem& problem, const Prepared& prepared);

/// Returns options that soften contact springs too stiff for cheap steps (`springs_stiff_for_step`); otherwise empty.
std::string softer_springs(const Prepared& prepared);

/// Describes the smallest block by its number, place and area over the mean; empty without blocks.
std::string smallest_block(const Blocks& blocks);

}  // namespace keyblock
