// Finds the parent of each element in a recut scene; keeps the names of elements in checkpoints.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/archive.hpp"
#include "model/model.hpp"

namespace keyblock {

/// Returns, per element of `after`, its parent in `before`. Both models have the same rock, with different cracks and
/// meshes of NMM bodies. The DDA blocks, which come first, are the same. The parent of an NMM element holds a point
/// inside it, or is nearest to one.
Table<ElementIndex, ElementIndex> parents_by_place(const Model& before, const Model& after);

void save_names(Archive& archive, const Model& model);

/// Gives elements the saved names. Refuses names of another number of elements.
void restore_names(Archive& saved, Model& model);

}  // namespace keyblock
