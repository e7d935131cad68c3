// Judges the contact forces of each connected set by the forces of the set.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Ratio of forces up to which connected sets are judged, and solved for at the start, together.
inline constexpr double kAlikeForces = 10;

/// Returns per element the fraction of the scene's tolerances of force that judges contact forces on it in a step of
/// `dt`. It is the ratio of two scales of force: that of the set of blocks which `touches` and bolts connect, and that
/// of the scene. Sets within kAlikeForces of the scene have the whole, as have those without load, momentum and force,
/// and elements that cannot move. Empty: all have the whole. So it is in scenes of one set and with NMM bodies.
std::vector<double> shares_of_sets(const StandardScene& scene, const Motion& start, const UnknownsTable& loads,
                                   const Touches& touches, double dt);

}  // namespace keyblock
