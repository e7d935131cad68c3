// Builds a model of DDA blocks next to NMM bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/model.hpp"
#include "problem/analysis.hpp"
#include "problem/blocks.hpp"
#include "problem/cover_plan.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Builds the model. Blocks of the materials that the plan's mesh names, or all without names, become NMM bodies. Each
/// has a mesh of its own, with sides of at most a square of its area. Other blocks stay DDA blocks and come first. A
/// plan without a mesh changes nothing. Points and bolts keep their order; `Identities::blocks` names the block of each
/// element. `joints_inside`: pieces of joints that divide no block; NMM bodies have them as slits. Throws InputError if
/// meshing is impossible.
Model mixed_model(const Blocks& blocks, const Analysis& analysis, const CoverPlan& plan, const Settings& settings,
                  const std::vector<CrackPlan>& joints_inside = {});

}  // namespace keyblock
