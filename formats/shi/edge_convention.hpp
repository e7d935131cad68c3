// Which edge the joint material of a vertex slot belongs to, found out from the edges that blocks share.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/blocks.hpp"

namespace keyblock::formats {

enum class EdgeConvention { arriving, leaving };

/// Both blocks beside a shared edge must give it one material; the convention under which more of them agree
/// wins, a tie is arriving. Vertices are matched within 1e-5 of the scene's half size (old files hold 6
/// decimals).
EdgeConvention convention_of(const std::vector<BlockPolygon>& blocks);

/// Materials of the edges that leave the vertices, moved to the vertices where they arrive.
std::vector<BlockPolygon> with_arriving_edges(std::vector<BlockPolygon> blocks);

}  // namespace keyblock::formats
