// Forces on the mass of a block: weight, and the acceleration that is given beside it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "settings/settings.hpp"

namespace keyblock {

/// Weight and horizontal body force per area, force / length². Weight under the quirk weight_of_first_material density
/// × gravity. Without it the unit weight of the material, turned and scaled as gravity is against that of the file: w g
/// / |g_file|, so that a unit weight that is not density × gravity (buoyant rock) keeps its ratio. Where the file has
/// no gravity, unit weights cannot be scaled: they act downward as they are, and density × gravity is added.
Eigen::Vector2d weight_per_area(const BlockMaterial& material, const Settings& settings);

/// The given acceleration at `time`, length / time²: force per mass on every block, at its centroid.
Eigen::Vector2d body_acceleration_at(const Settings& settings, double time);

/// False where body_acceleration_at is zero at every time.
bool has_body_acceleration(const Settings& settings);

}  // namespace keyblock
