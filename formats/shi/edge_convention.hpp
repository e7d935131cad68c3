// Finds the edge to which the joint material of a vertex slot belongs, from the edges that blocks share.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/blocks.hpp"

namespace keyblock::formats {

enum class EdgeConvention { arriving, leaving };

/// Returns the convention under which more blocks agree; a tie is arriving. Both blocks at a shared edge must give it
/// one material. Vertices are matched within 1e-5 of the scene's half size (files of Shi's programs have 6 decimals).
EdgeConvention convention_of(const std::vector<BlockPolygon>& blocks);

/// Moves materials of the edges that leave the vertices to the vertices where they arrive.
std::vector<BlockPolygon> with_arriving_edges(std::vector<BlockPolygon> blocks);

}  // namespace keyblock::formats
