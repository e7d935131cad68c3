// Declares the displacement of blocks whose faces are glued together, from which the start dissolves the glue.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/find/touch.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Returns the largest mass.
double heaviest(const Table<ElementIndex, Body>& bodies);

/// Glues all faces and loads them together with bolts and fixed points. The search for friction begins at the glue
/// forces.
void load_glued(const StandardScene& scene, const Touches& touches, const UnknownsTable& loads, Motion& motion);

}  // namespace keyblock
