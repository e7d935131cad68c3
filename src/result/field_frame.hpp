// One reported instant within the elements: displacement and stress at their corners.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/point.hpp"
#include "problem/analysis.hpp"
#include "result/plastic_state.hpp"

namespace keyblock {

/// A corner where it stood before any displacement.
struct FieldCorner {
  Point position;
  Point displacement;
  Stress stress;                    ///< as the element has it: neighbours need not agree
  Rare<PlasticState> plastic = {};  ///< none of rock that cannot yield
};

/// One element; loops as in `ElementFrame`.
struct FieldElement {
  int body = 0;      ///< index from 0
  int material = 0;  ///< block material, index from 0
  std::vector<std::vector<FieldCorner>> loops;
  FieldCorner middle;  ///< its centroid
};

/// A piece of a face of a crack: an edge of an element.
struct CrackFace {
  bool is_left = false;                  ///< the rock lies to the left of the way along the crack
  std::array<FieldCorner, 2> ends = {};  ///< in the order of the crack
};

struct CrackFrame {
  bool is_shear = false;     ///< it started in shear as cracks grew
  std::vector<Point> along;  ///< undeformed
  std::vector<CrackFace> faces = {};
};

struct FieldFrame {
  int step = 0;  ///< 0 is the state before the first load step
  double time = 0;
  std::vector<FieldElement> elements;
  std::optional<PlasticTotals> plastic = {};  ///< none where no rock may yield
  bool is_of_blocks = false;                  ///< all corners of an element have its stress
  std::vector<CrackFrame> cracks = {};        ///< by number
};

/// As many as elements where each is a block.
std::size_t body_count(const FieldFrame& field);

}  // namespace keyblock
