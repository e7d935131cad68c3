// The groups that the bodies of a model fall into.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene/scene.hpp"
#include "step/groups/block_group.hpp"

namespace keyblock {

struct MadeGroups {
  BodyGroups all;
  std::shared_ptr<const BlockGroup> blocks;      ///< one of them
  std::shared_ptr<const Groundwork> groundwork;  ///< of those on covers; none without them
};

/// Puts into `reference` how the elements of each group move. `before`: groundwork that may be of this model and these
/// settings, or none. Throws NotPositiveDefinite where covers carry no mass.
MadeGroups groups_of(const Model& model, const Settings& settings, Reference& reference,
                     const std::shared_ptr<const Groundwork>& before);

}  // namespace keyblock
