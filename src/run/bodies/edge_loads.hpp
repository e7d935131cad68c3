// Gathers the loads and supports along edges of DDA blocks from the list of loads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/scene/scene.hpp"
#include "problem/load_list.hpp"

namespace keyblock {

/// Gives the model the loads and supports of its DDA blocks, instead of those it has. Their bases are chosen already. A
/// block has as many rows of support as its motion has components: rows that follow from others are left out. Throws
/// InputError if a formula is not finite, or if a block of uniform strain cannot follow the prescribed displacements of
/// its edges.
void put_edge_loads(Model& model, const LoadList& loads);

/// Returns warnings of chains that lie partly off all edges. `scenes`: those of a run, in sequence. Throws InputError
/// for a chain on no edge, and for a load on an NMM body that changes over time where the scene permits none.
Warnings look_at_loads(const LoadList& loads, const std::vector<const Scene*>& scenes);

}  // namespace keyblock
