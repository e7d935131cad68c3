// The stages of a case as a chain of scenes, all made before the run begins.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "problem/problem.hpp"
#include "run/stages/rock.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {

/// The choices of each stage, those of the stages before it included, below the overrides; of a problem without stages
/// the one set of choices. `step_count` is that of the whole run. A profile or a time step other than that of
/// `standard` makes as many more or fewer steps, so that stages last as long. Throws as `settings_of`, and InputError
/// for other dynamics than those of `standard`.
struct StageChoices {
  Settings settings;
  int steps = 0;  ///< of the stage, at most
};
std::vector<StageChoices> choices_of_stages(const Problem& problem, const std::string& profile,
                                            const std::vector<Override>& overrides);

/// What makes the model of a stage (the first is 0) from its rock, ready to be stepped, and says which element of the
/// model before each of its elements is a part of. Throws InputError where there is none.
struct StagedModels {
  std::function<Model(const Rock& rock, int stage, const Settings& settings)> make;
  std::function<Table<ElementIndex, ElementIndex>(const Model& before, const Model& after, const Descent& descent)>
      parents;
  bool is_untouched = false;  ///< as Scene has it
};

/// Of blocks: `make` is still to be followed by the choice of their bases.
Table<ElementIndex, ElementIndex> block_parents(const Model& before, const Model& after, const Descent& descent);

/// When the scene of a stage ends.
SceneEnd end_of(const Stage& stage, const StageChoices& choices);

/// A scene of the same fixed points and bolts in their order, as it follows a model; `parents` says what its elements
/// were. Of several pieces of one element the first keeps its name, others are numbered on from `next_number`.
SceneChange change_between(const Model& before, Scene after, Table<ElementIndex, ElementIndex> parents,
                           int& next_number);

/// The scenes of the second stage and those after it, `rock` being that of the first, and `first` its model as it is
/// stepped; none where there is one stage. Adds what is to be said of the stages to the warnings. Throws InputError
/// where something cannot be changed as a stage says.
std::shared_ptr<const SceneChange> later_scenes(const Problem& problem, const Rock& rock, const Model& first,
                                                const std::vector<StageChoices>& choices, const StagedModels& models,
                                                Warnings& warnings);

}  // namespace keyblock
