// Merges slivers among cut blocks with their neighbours, or deletes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cut/bodies/cut_blocks.hpp"

namespace keyblock {

/// Treats slivers until none is left; the mean area is that of the remaining blocks.
///
/// Glued: merges the smallest first, each with the neighbour that shares the longest length of side. The larger of the
/// two gives number, block material and place; the union carries the points and bolts of both. A sliver that shares a
/// side with no block stays.
///
/// Left out: deletes the block. Throws InputError if it carries a point or a bolt, or if no block would be left.
///
/// Adds the warning `slivers_glued` or `slivers_left_out` with count, places and share of the total area. Adds
/// `setting_without_effect` if there are no slivers.
CutResult with_slivers_treated(CutResult cut, Slivers slivers);

}  // namespace keyblock
