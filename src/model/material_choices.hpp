// Looks up settings that materials may override. Materials count from 0.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Returns rebound over approach speed of an impact against an edge of this joint material.
double restitution_of(const Settings& settings, int joint_material);

/// Returns the enforcement of contact conditions at an edge of this joint material.
Enforcement enforcement_of(const Settings& settings, int joint_material);

/// Returns true if contacts of some joint material are enforced this way.
bool has_enforcement(const Settings& settings, const Model& model, Enforcement enforcement);

/// Returns true if no block carries its velocity from step to step.
bool is_static(const Settings& settings, const Model& model);

}  // namespace keyblock
