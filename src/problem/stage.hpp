// A stage of a case: what changes in the scene at its beginning, and when it ends.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"
#include "problem/cover_plan.hpp"
#include "problem/drawing.hpp"

namespace keyblock {

/// What lies within the outline, where it was drawn, is gone from here on. The faces that this leaves have the joint
/// material.
struct StageExcavation {
  std::vector<Point> outline;
  int joint_material = 0;  ///< index from 0
  Place place;
};

/// Blocks whose centroid lies within the outline, where it was drawn, are of this block material from here on.
struct StageMaterial {
  std::vector<Point> outline;
  int block_material = 0;  ///< index from 0
  Place place;
};

/// Edges of one joint material are of another from here on.
struct StageJointMaterial {
  int from = 0;  ///< index from 0
  int to = 0;
  Place place;
};

/// Fixed points that were drawn within the outline are free from here on.
struct StageRelease {
  std::vector<Point> outline;
  Place place;
};

/// A constant force on the block that was drawn around the point.
struct StageForce {
  Point at;
  Point force;
  Place place;
};

/// A bolt by its number: those of the geometry come first, then those that stages install, in their order.
struct StageBolt {
  int bolt = 0;  ///< index from 0
  Place place;
};

/// All coordinates are those of the drawing, wherever the blocks have moved since.
struct Stage {
  std::string name;
  int steps = 0;                      ///< how many at most; 0: the duration says
  double duration = 0;                ///< T; 0: the steps say
  std::optional<double> equilibrium;  ///< ends earlier where forces are balanced to this share of the largest load

  std::vector<StageExcavation> excavations;
  std::vector<JointLine> cuts;  ///< blocks that a line passes through come apart along it
  std::vector<StageMaterial> block_materials;
  std::vector<StageJointMaterial> joint_materials;
  std::vector<BoltLine> bolts;  ///< installed with their pretension between the blocks as they lie
  std::vector<StageBolt> removed_bolts;
  std::vector<MarkedPoint> held;  ///< points that are held where they are
  std::vector<StageRelease> released;
  std::vector<StageForce> forces;
  bool removes_forces = false;  ///< those of loading points and of stages before

  std::optional<MeshPlan> mesh;  ///< blocks of its materials, of all where it names none, are on covers from here on

  std::string profile;                                        ///< empty: as before
  std::vector<std::pair<std::string, std::string>> settings;  ///< as `RunChoices::settings`, on top of those before

  Place place;
};

}  // namespace keyblock
