// From one scene of a run to the next: what everything in it was before.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/model.hpp"

namespace keyblock {

/// Of everything in the later scene, the index of what it was in the earlier one.
struct SceneMap {
  Table<ElementIndex, ElementIndex> elements;  ///< that it is, or is a piece of
  Table<VertexIndex, VertexIndex> vertices;    ///< at the same place of that element; none where it had no vertex there
  std::vector<int> fixed_points;               ///< below 0: new
  std::vector<int> bolts;                      ///< below 0: new
};

/// The vertices of every element of `after` by those of the element that it was.
Table<VertexIndex, VertexIndex> vertices_before(const Model& before, const Model& after,
                                                const Table<ElementIndex, ElementIndex>& elements);

}  // namespace keyblock
