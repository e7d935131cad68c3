// Whether blocks are at rest under their loads, and which are not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "step/scene/standard_scene.hpp"

namespace keyblock {

struct Balance {
  double share = 0;                  ///< largest force out of balance over the largest load
  std::vector<ElementIndex> blocks;  ///< those that are out of balance
  bool holds_points = true;          ///< held points are where their motion wants them

  bool holds() const { return blocks.empty() && holds_points; }
};

/// Of loads, stress and the remembered contact forces at `time`; velocities count for nothing. Moments and strain
/// forces are taken over the size of the block. The largest load counts as no smaller than `least_load`.
Balance balance_of(const StandardScene& scene, const Motion& motion, double time, double least_load = 0);

/// Largest force that brings a block within dt to where its held points are driven to by `time`; 0 where they are
/// there. It stands for the load in scenes without one.
double driving_force(const StandardScene& scene, const Motion& motion, double time, double dt);

/// The largest load, or force of the initial stress, on a block.
double largest_load(const StandardScene& scene, const UnknownsTable& loads);

/// Greatest way of a vertex between two motions over the size of its block, and the blocks that came further than `far`
/// of their size, unless two points hold them: an equilibrium as far away as that size is another one.
struct Travel {
  double share = 0;
  std::vector<ElementIndex> far;
};
Travel travel_of(const StandardScene& scene, const UnknownsTable& from, const UnknownsTable& to, double far = 1);

/// "block 3", or "element 3" of an NMM body, as tables number them.
std::string part_name(const StandardScene& scene, ElementIndex e);

/// "block 3 (at 2.5, 1; area 0.04, 0.312 % of the mean)": which of them, and where they lay at the start.
std::string in_words(const StandardScene& scene, const std::vector<ElementIndex>& blocks);

/// "no equilibrium: block 3 accelerates (at 2.5, 1; area 0.04, 0.312 % of the mean)", place and area those at the
/// start, of the smallest where there are several; of an element on covers also that nothing holds its body.
std::string no_equilibrium(const StandardScene& scene, const std::vector<ElementIndex>& blocks);

}  // namespace keyblock
