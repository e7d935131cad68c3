// Warns of sizes, densities, moduli, gravities and angles that are not plausible in the declared units.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/error.hpp"
#include "model/model.hpp"
#include "problem/problem.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Returns warnings about the size of the scene, the gravity and all materials: `implausible_size`,
/// `implausible_gravity`, `gravity_points_upward` and those of materials.
Warnings implausible_units(const Problem& problem, const Settings& settings, const Model& model);

/// Returns warnings about a block material: `implausible_modulus`, `implausible_density`, `implausible_strength` and
/// `angle_in_radians`.
Warnings contradictions_of(const BlockMaterial& material, const Units& units);

/// Returns width and height of all bodies before any load, "30 m by 14 m"; empty without bodies.
std::string size_of_scene(const Model& model, const Units& units);

}  // namespace keyblock
