// A model of blocks beside bodies on covers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/model.hpp"
#include "problem/analysis.hpp"
#include "problem/blocks.hpp"
#include "problem/cover_plan.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// The blocks of the materials that the mesh of the plan names, of all where it names none, each on a mesh of its own
/// whose sides are at most that of a square of its area; the others stay blocks and come first. A plan without a mesh
/// leaves all as they are. Points and bolts keep their
/// order, and `Identities::blocks` says what each element was cut from. `joints_inside`: pieces of joints that part no
/// block; those on covers have them as slits. Throws InputError where the mesh cannot be.
Model mixed_model(const Blocks& blocks, const Analysis& analysis, const CoverPlan& plan, const Settings& settings,
                  const std::vector<CrackPlan>& joints_inside = {});

}  // namespace keyblock
