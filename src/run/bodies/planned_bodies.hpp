// The bodies of a case on their mesh, at any load step: what is dug out by then is gone.
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
  /// `problem` has a drawing, blocks or a cover file, an analysis and covers; views it. Throws InputError where it has
  /// not, or where the mesh cannot be. The mesh of a cover file is its own, bisected where the plan says.
  explicit PlannedBodies(const Problem& problem);

  /// The bodies at a load step; at 0 whole. Throws InputError where nothing is left.
  Manifold at(int step) const;
  bool changes_at(int step) const;  ///< something is dug out there

  const Blocks& blocks() const { return blocks_; }  ///< that the bodies of step 0 were
  const std::vector<BlockPoint>& measured_points() const {
    return blocks_.measured_points;
  }  ///< their blocks are bodies of step 0
  const Warnings& warnings() const { return warnings_; }

 private:
  Manifold cut_at(int step) const;

  const Problem& problem_;
  std::vector<BodyGraph> graphs_;  ///< of the whole bodies: one for a drawing, one a block
  TriangleMesh mesh_;
  Blocks blocks_;
  Warnings warnings_;
};

/// Of the triangles at tips: what the plan says, or a sixteenth of the increment by which its cracks grow, 0 without
/// any.
double tip_side_of(const CoverPlan& plan);

/// Whether there is more than one body, or a joint that ends inside one. Throws as the constructor.
bool bodies_touch(const Problem& problem);

/// Whether there is one body, of which nothing but the faces of its cracks lie on each other. Throws likewise.
bool only_faces_touch(const Problem& problem);

}  // namespace keyblock
