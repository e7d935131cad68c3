// Maps a scene of a run to the one before: gives the earlier index of each item.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/model.hpp"

namespace keyblock {

/// Per item of the later scene, its index in the earlier one.
struct SceneMap {
  Table<ElementIndex, ElementIndex> elements;  ///< that it is, or is a piece of
  Table<VertexIndex, VertexIndex> vertices;    ///< at the same place of that element; unset if it had no vertex there
  std::vector<int> fixed_points;               ///< negative: new
  std::vector<int> bolts;                      ///< negative: new
};

/// Matches the vertices of every element of `after` with those of the element that it was.
Table<VertexIndex, VertexIndex> vertices_before(const Model& before, const Model& after,
                                                const Table<ElementIndex, ElementIndex>& elements);

}  // namespace keyblock
