// Chooses between multipliers and springs from the contacts of the blocks as drawn. Theory:
// docs/theory/05-frictional-contact.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "contact/find/candidates.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Returns the pairs of blocks whose outlines initially meet within kTouching of block size.
std::vector<ElementPair> touching_pairs(const Model& model);

/// Returns true if some blocks joined by these pairs form a ring, as in a jointed mass or an arch. Stacks and rows of
/// blocks form no ring. All fixed blocks count as one.
bool has_ring(const Model& model, const std::vector<ElementPair>& touching);

/// Resolves `automatic`: penalty if springs stop impacts, if NMM bodies exist, or if more than a few blocks touch in a
/// ring. Also penalty if bonds hold a few blocks at more points than they can follow, or, in statics, bonds and
/// friction do; that of three blocks or fewer, or without a ring, does not count. Otherwise lagrange. Forces in a ring
/// are highly redundant. On a slope of 45 blocks multipliers took five times the solves of springs and left steps
/// unfinished.
Settings with_enforcement_decided(Settings settings, const Model& model);

/// Returns the reason for the decision on `automatic`, as one clause.
std::string why_enforcement(const Model& model, const Settings& settings);

}  // namespace keyblock
