// Computes forces on the mass of a block: its weight, and a prescribed acceleration.
// Theory: docs/theory/02-equations-of-motion.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "settings/settings.hpp"

namespace keyblock {

/// Returns weight and horizontal body force per area [force / length²].
///
/// Under the quirk weight_of_first_material the weight is density × gravity. Without it the unit weight w of the
/// material is rotated and scaled with the gravity g relative to that of the file: w g / |g_file|. A unit weight that
/// is not density × gravity (buoyant rock) so keeps its ratio. If the file has no gravity, unit weights act downward
/// unscaled, and density × gravity is added.
Eigen::Vector2d weight_per_area(const BlockMaterial& material, const Settings& settings);

/// Returns the prescribed acceleration at `time` [length / time²]: a force per mass on every block, at its centroid.
Eigen::Vector2d body_acceleration_at(const Settings& settings, double time);

/// Returns false if body_acceleration_at is zero at every time.
bool has_body_acceleration(const Settings& settings);

}  // namespace keyblock
