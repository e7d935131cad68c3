// Holds a stage of a case: the changes of the scene at its beginning, and the condition for its end.
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

/// Excavation of the rock that was drawn within the outline. The new faces have the joint material.
struct StageExcavation {
  std::vector<Point> outline;
  int joint_material = 0;  ///< index from 0
  Place place;
};

/// Change of material: blocks whose centroid was drawn within the outline get this block material.
struct StageMaterial {
  std::vector<Point> outline;
  int block_material = 0;  ///< index from 0
  Place place;
};

/// Change of the material of edges from one joint material to another.
struct StageJointMaterial {
  int from = 0;  ///< index from 0
  int to = 0;
  Place place;
};

/// Release: fixed points that were drawn within the outline become free.
struct StageRelease {
  std::vector<Point> outline;
  Place place;
};

/// Constant force on the block that was drawn around the point.
struct StageForce {
  Point at;
  Point force;
  Place place;
};

/// Bolt by its number: those of the geometry come first, then those that stages install, in their order.
struct StageBolt {
  int bolt = 0;  ///< index from 0
  Place place;
};

/// Stage of a case. All coordinates are those of the drawing, even if the blocks have moved since.
struct Stage {
  std::string name;
  int steps = 0;                      ///< largest number of steps; 0: set by the duration
  double duration = 0;                ///< T; 0: set by the steps
  std::optional<double> equilibrium;  ///< ends earlier if forces balance to this share of the largest load

  std::vector<StageExcavation> excavations;
  std::vector<JointLine> cuts;  ///< blocks that a line crosses are cut along it
  std::vector<StageMaterial> block_materials;
  std::vector<StageJointMaterial> joint_materials;
  std::vector<BoltLine> bolts;  ///< installed with their pretension between the blocks at their present places
  std::vector<StageBolt> removed_bolts;
  std::vector<MarkedPoint> held;  ///< points that are fixed at their present places
  std::vector<StageRelease> released;
  std::vector<StageForce> forces;
  bool removes_forces = false;  ///< those of loading points and of earlier stages

  std::optional<MeshPlan> mesh;  ///< blocks of its materials, or all if it names none, become NMM bodies

  std::string profile;                                        ///< empty: as before
  std::vector<std::pair<std::string, std::string>> settings;  ///< as `RunChoices::settings`, added to earlier ones

  Place place;
};

}  // namespace keyblock
