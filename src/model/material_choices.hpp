// Choices that materials may make for themselves, as steps ask for them. Materials count from 0.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Rebound over approach speed of an impact against an edge of this joint material.
double restitution_of(const Settings& settings, int joint_material);

/// How contact forces come about against an edge of this joint material.
Enforcement enforcement_of(const Settings& settings, int joint_material);

/// True if contacts of some joint material are enforced so.
bool has_enforcement(const Settings& settings, const Model& model, Enforcement enforcement);

/// True if no block carries its velocity over from step to step.
bool is_static(const Settings& settings, const Model& model);

}  // namespace keyblock
