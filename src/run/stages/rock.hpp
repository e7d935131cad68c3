// Holds the blocks of a run as its stages change them, with their points, bolts and names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "cut/bodies/change_blocks.hpp"
#include "model/scene/scene_map.hpp"
#include "problem/analysis.hpp"
#include "problem/stage.hpp"

namespace keyblock {

/// Blocks at their places in the drawing; their displacements are unknown here. The result of a stage is therefore
/// independent of the run.
struct Rock {
  Blocks blocks;
  Analysis analysis;                 ///< with a motion per fixed point and a load per loading point
  Identities identities;             ///< of measured points and bolts; elements are named with the models
  std::vector<char> holds_in_place;  ///< per fixed point
  int next_bolt = 0;
};

/// Returns the rock as in the files.
Rock rock_of(Blocks blocks, Analysis analysis);

/// Earlier index of everything that a stage leaves; negative for new items.
struct Descent {
  std::vector<int> blocks;
  std::vector<int> fixed_points;
  std::vector<int> bolts;
};

struct ChangedRock {
  Rock rock;
  Descent descent;
  Warnings warnings;  ///< of requests of a stage without effect
};

/// Applies excavations first, then cuts, materials, bolts, points and forces. Throws InputError at the place of an
/// invalid item. Such items are an outline that crosses itself, an unknown material or bolt, and a bolt without length.
/// Others are a point or bolt end in no block, and an excavation that leaves no block.
ChangedRock changed(const Rock& rock, const Stage& stage);

/// Returns the model of its blocks; bases are still to be chosen.
Model model_of(const Rock& rock);

/// Gives a model of the rock the names of its points and bolts, and marks points that hold in place.
void name_points(Model& model, const Rock& rock);

}  // namespace keyblock
