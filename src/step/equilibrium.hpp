// Whether blocks are at rest under their loads, and which are not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "step/standard_scene.hpp"

namespace keyblock {

struct Balance {
  double share = 0;                  ///< largest force out of balance over the largest load
  std::vector<ElementIndex> blocks;  ///< those that are out of balance

  bool holds() const { return blocks.empty(); }
};

/// Of loads, stress and the remembered contact forces at `time`; velocities count for nothing. Moments and strain forces
/// are taken over the size of the block.
Balance balance_of(const StandardScene& scene, const Motion& motion, double time);

/// The largest load, or force of the initial stress, on a block.
double largest_load(const StandardScene& scene, const UnknownsTable& loads);

/// Greatest way of a vertex between two motions over the size of its block, and the blocks that came further than their own
/// size: an equilibrium so far away is another one.
struct Travel {
  double share = 0;
  std::vector<ElementIndex> far;
};
Travel travel_of(const StandardScene& scene, const UnknownsTable& from, const UnknownsTable& to);

/// "no equilibrium: block 3 accelerates".
std::string no_equilibrium(const std::vector<ElementIndex>& blocks);

}  // namespace keyblock
