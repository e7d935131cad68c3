// Builds the bodies of a case on their mesh at any load step, without the parts excavated by then.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "cut/bodies/cut_blocks.hpp"
#include "problem/manifold.hpp"
#include "problem/problem.hpp"

namespace keyblock {

class PlannedBodies {
 public:
  /// Takes a `problem` with a drawing, blocks or a cover file, an analysis and covers; keeps a reference. Throws
  /// InputError if one is missing or meshing is impossible. A cover file has its own mesh, bisected as the plan says.
  explicit PlannedBodies(const Problem& problem);

  /// Returns the bodies at a load step; whole at 0. Throws InputError if nothing is left.
  Manifold at(int step) const;

  const Blocks& blocks() const { return blocks_; }  ///< before meshing, at step 0
  const std::vector<BlockPoint>& measured_points() const {
    return blocks_.measured_points;
  }  ///< their blocks are bodies of step 0
  const Warnings& warnings() const { return warnings_; }

 private:
  Manifold cut_at(int step) const;

  const Problem& problem_;
  std::vector<BodyGraph> graphs_;  ///< of the whole bodies: one per drawing, or one per block
  TriangleMesh mesh_;
  Blocks blocks_;
  Warnings warnings_;
};

/// Returns the side of triangles at tips: that of the plan, or a sixteenth of the growth increment, or 0 without
/// growth.
double tip_side_of(const CoverPlan& plan);

/// Returns true if there are several bodies, or a joint that ends inside one. Throws as the constructor.
bool bodies_touch(const Problem& problem);

/// Returns true if there is one body, in contact only at the faces of its cracks. Throws as the constructor.
bool only_faces_touch(const Problem& problem);

}  // namespace keyblock
