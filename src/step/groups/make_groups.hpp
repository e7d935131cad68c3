// The groups that the bodies of a model fall into.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/groups/block_group.hpp"

namespace keyblock {

struct MadeGroups {
  BodyGroups all;
  std::shared_ptr<const BlockGroup> blocks;  ///< one of them
};

/// Puts into `reference` how the elements of each group move. Throws NotPositiveDefinite where covers carry no mass.
MadeGroups groups_of(const Model& model, const Settings& settings, Reference& reference);

}  // namespace keyblock
