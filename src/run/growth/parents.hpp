// What each element of a scene that was cut anew is a part of.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"

namespace keyblock {

/// Of models of the same rock, which differ by cracks and by the mesh of bodies on covers: the blocks before them are
/// the same; of an element on covers that which holds a point inside it, or comes nearest to one.
Table<ElementIndex, ElementIndex> parents_by_place(const Model& before, const Model& after);

}  // namespace keyblock
