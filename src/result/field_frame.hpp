// Holds one reported instant within the elements: displacement and stress at their corners.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/point.hpp"
#include "problem/analysis.hpp"
#include "result/plastic_state.hpp"

namespace keyblock {

/// Corner at its place before any displacement.
struct FieldCorner {
  Point position;
  Point displacement;
  Stress stress;                    ///< from the element: neighbours need not agree
  Rare<PlasticState> plastic = {};  ///< empty for rock that cannot yield
};

/// Element; loops as in `ElementFrame`.
struct FieldElement {
  int body = 0;      ///< index from 0
  int material = 0;  ///< block material, index from 0
  std::vector<std::vector<FieldCorner>> loops;
  FieldCorner middle;  ///< its centroid
};

/// Piece of a face of a crack: an edge of an element.
struct CrackFace {
  bool is_left = false;                  ///< the rock lies to the left of the crack's direction
  std::array<FieldCorner, 2> ends = {};  ///< in the order of the crack
};

struct CrackFrame {
  bool is_shear = false;     ///< it started in shear during the run
  std::vector<Point> along;  ///< undeformed
  std::vector<CrackFace> faces = {};
};

struct FieldFrame {
  int step = 0;  ///< 0 is the state before the first load step
  double time = 0;
  std::vector<FieldElement> elements;
  std::optional<PlasticTotals> plastic = {};  ///< empty if no rock may yield
  bool is_of_blocks = false;                  ///< each element is a body, with one stress
  std::vector<CrackFrame> cracks = {};        ///< by number
  bool is_uniform = false;                    ///< all corners of an element have its stress
};

/// Returns the number of bodies; it equals the number of elements if each is a block.
std::size_t body_count(const FieldFrame& field);

}  // namespace keyblock
