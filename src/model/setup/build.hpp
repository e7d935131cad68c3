// What all ways to a model have in common: elements with their loops, and the scale of the scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/model.hpp"

namespace keyblock {

/// A corner of a loop, and what is said of the edge that arrives at it.
struct Corner {
  Point position;
  int joint_material = 0;
  bool is_inner = false;
};

/// Appends an element without loops. Material numbers that do not exist are taken as the nearest that does.
void begin_element(Model& model, int material, const Basis& basis, CoverList covers);

/// Appends a loop to the last element: the outer one first, then its holes. All of it is boundary.
void add_loop(Model& model, const std::vector<Corner>& corners);

/// Half the greater of width and height of all vertices (legacy-rules, notation).
double scale_of(const std::vector<Point>& vertices);

}  // namespace keyblock
