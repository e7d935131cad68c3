// Adds elements with their loops to a model, and computes the scale of the scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/model.hpp"

namespace keyblock {

/// Corner of a loop, with the properties of the edge that arrives at it.
struct Corner {
  Point position;
  int joint_material = 0;
  bool is_inner = false;
};

/// Appends an element without loops. A material number out of range becomes the nearest that exists.
void begin_element(Model& model, int material, const Basis& basis, CoverList covers);

/// Appends a loop to the last element: the outer one first, then its holes. All of it is boundary.
void add_loop(Model& model, const std::vector<Corner>& corners);

/// Returns half the greater of width and height of all vertices (legacy-rules, notation).
double scale_of(const std::vector<Point>& vertices);

}  // namespace keyblock
