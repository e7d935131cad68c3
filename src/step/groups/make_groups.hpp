// Divides the bodies of a model into groups.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene/scene.hpp"
#include "step/groups/block_group.hpp"

namespace keyblock {

struct MadeGroups {
  BodyGroups all;
  std::shared_ptr<const BlockGroup> blocks;      ///< one of them
  std::shared_ptr<const Groundwork> groundwork;  ///< cached data of NMM bodies; null without them
};

/// Creates the groups and writes the kinematics of their elements into `reference`. `before`: cached data, used if they
/// fit this model and these settings, or null. Throws NotPositiveDefinite if covers have no mass.
MadeGroups groups_of(const Model& model, const Settings& settings, Reference& reference,
                     const std::shared_ptr<const Groundwork>& before);

}  // namespace keyblock
