// The blocks of a run as its stages change them, with what they carry and what they are called.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "cut/bodies/change_blocks.hpp"
#include "model/scene/scene_map.hpp"
#include "problem/analysis.hpp"
#include "problem/stage.hpp"

namespace keyblock {

/// Where everything stands in the drawing; how far it has moved is not known here. What follows from a stage is
/// therefore the same however the run went.
struct Rock {
  Blocks blocks;
  Analysis analysis;                 ///< with a motion for every fixed point and a load for every loading point
  Identities identities;             ///< of measured points and bolts; elements are named with the models
  std::vector<char> holds_in_place;  ///< of every fixed point
  int next_bolt = 0;
};

/// As the files have it.
Rock rock_of(Blocks blocks, Analysis analysis);

/// Of everything that a stage leaves: its index before, below 0 of what is new.
struct Descent {
  std::vector<int> blocks;
  std::vector<int> fixed_points;
  std::vector<int> bolts;
};

struct ChangedRock {
  Rock rock;
  Descent descent;
  Warnings warnings;  ///< of what a stage asks for and nothing answers to
};

/// Excavations first, then cuts, materials, bolts, points and forces. Throws InputError at the place of what cannot be:
/// an outline that crosses itself, a material or a bolt that there is none of, a bolt without length, a point or a
/// bolt's end in no block, no block left.
ChangedRock changed(const Rock& rock, const Stage& stage);

/// The model of its blocks; bases are still to be chosen.
Model model_of(const Rock& rock);

/// Gives a model of the rock the names of its points and bolts, and says which points hold in place.
void name_points(Model& model, const Rock& rock);

}  // namespace keyblock
