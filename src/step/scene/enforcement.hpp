// Multipliers or springs, decided from how the blocks touch at the start.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "contact/find/candidates.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Pairs of blocks whose outlines meet at the start, within a named share of block size.
std::vector<ElementPair> touching_pairs(const Model& model);

/// True if some blocks joined by these pairs stand in a ring, as in a jointed mass or an arch; stacks and rows of
/// blocks do not. All held blocks count as one.
bool has_ring(const Model& model, const std::vector<ElementPair>& touching);

/// `automatic` becomes penalty where springs stop impacts or more than a few blocks touch in a ring, lagrange
/// elsewhere: in a ring forces are many times redundant, and multipliers took five times the solves of springs and left
/// steps unfinished (a slope of 45 blocks).
Settings with_enforcement_decided(Settings settings, const Model& model);

/// One clause: why `automatic` decides as it does.
std::string why_enforcement(const Model& model, const Settings& settings);

}  // namespace keyblock
