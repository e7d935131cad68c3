// Checks whether blocks are in static equilibrium under their loads, and names those that are not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "step/scene/standard_scene.hpp"

namespace keyblock {

struct Balance {
  double share = 0;                  ///< largest imbalance over the largest load
  std::vector<ElementIndex> blocks;  ///< blocks out of balance
  bool holds_points = true;          ///< fixed points are at their targets

  bool holds() const { return blocks.empty() && holds_points; }
};

/// Returns the balance of loads, stress and the remembered contact forces at `time`, without velocities. Moments and
/// strain forces are divided by the size of the block. The largest load counts as at least `least_load`.
Balance balance_of(const StandardScene& scene, const Motion& motion, double time, double least_load = 0);

/// Returns the largest force that brings a block within dt to the targets of its fixed points at `time`; 0 if they are
/// there. It replaces the load in scenes without one.
double driving_force(const StandardScene& scene, const Motion& motion, double time, double dt);

/// Returns the largest load, or force of the initial stress, on a block.
double largest_load(const StandardScene& scene, const UnknownsTable& loads);

/// Returns true if an initial stress of the file loads bodies. `q`: any unknowns of the scene.
bool is_stressed(const StandardScene& scene, UnknownsTable q);

/// Returns the force that counts as a load where only an initial stress of the file loads bodies: a hundredth of the
/// largest that it causes. `q`: any unknowns of the scene.
double reference_of_stress(const StandardScene& scene, UnknownsTable q);
/// Returns the same of one DDA block.
double reference_of_stress(const Body& body);

/// Greatest displacement of a vertex between two motions over the size of its block. `far`: blocks that moved farther
/// than a given fraction of their size, unless two points hold them. An equilibrium at such a distance is another one.
struct Travel {
  double share = 0;
  std::vector<ElementIndex> far;
};
Travel travel_of(const StandardScene& scene, const UnknownsTable& from, const UnknownsTable& to, double far = 1);

/// Returns "block 3", or "element 3" of an NMM body, with the number used in tables.
std::string part_name(const StandardScene& scene, ElementIndex e);

/// Names blocks and their initial places, as in "block 3 (at 2.5, 1; area 0.04, 0.312 % of the mean)".
std::string in_words(const StandardScene& scene, const std::vector<ElementIndex>& blocks);

/// Reports "no equilibrium: block 3 accelerates (at 2.5, 1; area 0.04, 0.312 % of the mean)". Place and area are
/// initial values, of the smallest block if there are several. For an NMM element the sentence adds that its body has
/// no support.
Finding no_equilibrium(const StandardScene& scene, const std::vector<ElementIndex>& blocks);

}  // namespace keyblock
