// Slivers among blocks that were cut: glued to their neighbours, or left out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cut/bodies/cut_blocks.hpp"

namespace keyblock {

/// The blocks with their slivers treated, until none is left by the mean area of the blocks that then are.
/// Glued: the smallest first, each with the neighbour that it shares the longest length of side with; the larger of the
/// two gives number, block material and place, and carries the points and bolts of both. One that shares a side with
/// none stays.
/// Left out: the block is not there. Throws InputError where one carries a point or a bolt, or no block would be left.
/// Adds the warning `slivers_glued` or `slivers_left_out` with their number, places and share of all area, or
/// `setting_without_effect` where there are none.
CutResult with_slivers_treated(CutResult cut, Slivers slivers);

}  // namespace keyblock
