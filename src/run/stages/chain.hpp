// Builds the stages of a case as a chain of scenes before the run begins.
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

/// Choices of a stage. They include those of earlier stages; overrides replace them. A problem without stages has one
/// set of choices. `step_count` is that of the whole run. If profile or time step differ from `standard`, the number of
/// steps changes so that stages last as long. Throws as `settings_of`, and InputError for dynamics other than
/// `standard`.
struct StageChoices {
  Settings settings;
  int steps = 0;  ///< of the stage, at most
};
std::vector<StageChoices> choices_of_stages(const Problem& problem, const std::string& profile,
                                            const std::vector<Override>& overrides);

/// Functions of a staged case. `make` returns the model of a stage (the first is 0) from its rock, ready for steps.
/// `parents` returns, per element, the element of the earlier model that it is a part of. Throw InputError without a
/// model.
struct StagedModels {
  std::function<Model(const Rock& rock, int stage, const Settings& settings)> make;
  std::function<Table<ElementIndex, ElementIndex>(const Model& before, const Model& after, const Descent& descent)>
      parents;
  bool is_untouched = false;  ///< as in Scene
};

/// Returns the parents of DDA blocks: `make` must still be followed by the choice of their bases.
Table<ElementIndex, ElementIndex> block_parents(const Model& before, const Model& after, const Descent& descent);

/// Returns the end conditions of the scene of a stage.
SceneEnd end_of(const Stage& stage, const StageChoices& choices);

/// Gives elements the numbers of their parents. If an element has several pieces, the first keeps its number, others
/// are numbered from `next_number`.
void name_elements(const Model& before, Model& after, const Table<ElementIndex, ElementIndex>& parents,
                   int& next_number);

/// Returns the change to a scene with the same fixed points and bolts in order; `parents` are those of its elements,
/// which are named by them.
SceneChange change_between(const Model& before, Scene after, Table<ElementIndex, ElementIndex> parents,
                           int& next_number);

/// Returns the scenes of the second and later stages; null with one stage. `rock`: that of the first stage, `first` its
/// model as stepped. Appends warnings about the stages. Throws InputError if a change of a stage is impossible.
std::shared_ptr<const SceneChange> later_scenes(const Problem& problem, const Rock& rock, const Model& first,
                                                const std::vector<StageChoices>& choices, const StagedModels& models,
                                                Warnings& warnings);

}  // namespace keyblock
