// Makes the stages from first to last, then links them from last to first.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/stages/chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "run/settings_of.hpp"

namespace keyblock {
namespace {

// Number of steps that shows the step ratio of a profile with fewer or more steps than the file. Any number that the
// ratio divides would do.
constexpr int kSomeSteps = 1024;
// A duration within round-off of a whole number of steps is that number.
constexpr double kWholeSteps = 1e-9;

/// Returns a problem for `settings_of`, without its geometry.
Problem choices_alone(const Problem& problem) {
  Problem alone;
  alone.analysis = problem.analysis;
  alone.analysis->step_count = kSomeSteps;
  alone.choices = problem.choices;
  return alone;
}

int whole_steps(double steps, const Place& place) {
  const double whole = std::max(1.0, std::ceil(steps - kWholeSteps));
  if (!(whole <= std::numeric_limits<int>::max()))
    throw InputError(place, fmt::format("expected at most {} steps in a stage, found {:.6g}",
                                        std::numeric_limits<int>::max(), whole));
  return static_cast<int>(whole);
}

/// Returns the steps of a stage. `file_step`: time step to which the numbers of steps refer.
int steps_of(const Stage& stage, double file_step, double time_step) {
  const int by_steps = stage.steps > 0 ? whole_steps(stage.steps * (file_step / time_step), stage.place)
                                       : std::numeric_limits<int>::max();
  const int by_duration =
      stage.duration > 0 ? whole_steps(stage.duration / time_step, stage.place) : std::numeric_limits<int>::max();
  return std::min(by_steps, by_duration);
}

SceneMap map_between(const Model& before, const Model& after, Table<ElementIndex, ElementIndex> parents,
                     const Descent& descent) {
  SceneMap map;
  map.elements = std::move(parents);
  map.vertices = vertices_before(before, after, map.elements);
  map.fixed_points = descent.fixed_points;
  map.bolts = descent.bolts;
  return map;
}

}  // namespace

void name_elements(const Model& before, Model& after, const Table<ElementIndex, ElementIndex>& parents,
                   int& next_number) {
  Table<ElementIndex, char> is_taken(before.elements.size(), 0);
  after.identities.elements.clear();
  for (ElementIndex e : indices(parents)) {
    Identity identity = before.identities.of_element(parents[e].value);
    if (is_taken[parents[e]]) identity.number = next_number++;
    is_taken[parents[e]] = 1;
    after.identities.elements.push_back(identity);
  }
}

SceneChange change_between(const Model& before, Scene after, Table<ElementIndex, ElementIndex> parents,
                           int& next_number) {
  Descent descent;
  for (std::size_t i = 0; i < after.model.fixed_points.size(); ++i) descent.fixed_points.push_back(static_cast<int>(i));
  for (std::size_t i = 0; i < after.model.bolts.size(); ++i) descent.bolts.push_back(static_cast<int>(i));
  SceneChange change{std::move(after), {}};
  change.map = map_between(before, change.scene.model, std::move(parents), descent);
  name_elements(before, change.scene.model, change.map.elements, next_number);
  return change;
}

Table<ElementIndex, ElementIndex> block_parents(const Model&, const Model&, const Descent& descent) {
  Table<ElementIndex, ElementIndex> parents;
  for (const int parent : descent.blocks) parents.push_back({parent});
  return parents;
}

std::vector<StageChoices> choices_of_stages(const Problem& problem, const std::string& profile,
                                            const std::vector<Override>& overrides) {
  if (problem.stages.empty()) return {{settings_of(problem, profile, overrides), 0}};
  Problem asked = choices_alone(problem);
  std::string chosen = profile;
  std::vector<StageChoices> all;
  std::int64_t total = 0;
  for (const Stage& stage : problem.stages) {
    RunChoices& choices = asked.choices;
    choices.setting_places.resize(choices.settings.size(), choices.place);
    for (const auto& setting : stage.settings) {
      if (setting.first == "body_acceleration_file")  // one table is read, for the whole run
        throw InputError(stage.place,
                         "expected body_acceleration_file in the settings of the whole run, found it in a stage");
      choices.settings.push_back(setting);
      choices.setting_places.push_back(stage.place);
    }
    if (!stage.profile.empty()) {
      choices.profile = stage.profile;
      choices.profile_place = stage.place;
      chosen = profile_of(asked, {});
    }
    Settings settings = settings_of(asked, chosen, overrides);
    if (settings.dynamics != Dynamics::standard)
      throw InputError(stage.place,
                       fmt::format("expected dynamics standard for stages, found those of Shi (profile {})", chosen));
    if (!all.empty() && settings.slivers != all.front().settings.slivers)
      throw InputError(stage.place,
                       "expected the setting slivers of the first stage, for the rock is cut once, found another");
    const int steps = steps_of(stage, settings_of(asked, "standard", {}).time_step, settings.time_step);
    total += steps;
    all.push_back({std::move(settings), steps});
  }
  if (total > std::numeric_limits<int>::max())
    throw InputError(problem.stages.front().place, fmt::format("expected at most {} steps in all stages, found {}",
                                                               std::numeric_limits<int>::max(), total));
  for (StageChoices& choices : all) choices.settings.step_count = static_cast<int>(total);
  return all;
}

SceneEnd end_of(const Stage& stage, const StageChoices& choices) {
  return {stage.name, choices.steps, stage.equilibrium};
}

std::shared_ptr<const SceneChange> later_scenes(const Problem& problem, const Rock& rock, const Model& first,
                                                const std::vector<StageChoices>& choices, const StagedModels& models,
                                                Warnings& warnings) {
  std::vector<std::shared_ptr<SceneChange>> changes;
  Rock now = rock;
  const Model* before = &first;
  int next_number = first.elements.end_index().value;
  for (std::size_t i = 1; i < problem.stages.size(); ++i) {
    const Stage& stage = problem.stages[i];
    ChangedRock next = changed(now, stage);
    warnings = joined(std::move(warnings), next.warnings);
    auto change = std::make_shared<SceneChange>();
    Scene& scene = change->scene;
    scene.settings = choices[i].settings;
    scene.end = end_of(stage, choices[i]);
    scene.is_untouched = models.is_untouched;
    scene.model = models.make(next.rock, static_cast<int>(i), scene.settings);
    scene.model.scale = first.scale;  // tolerances of a run stay those of its beginning
    change->map = map_between(*before, scene.model, models.parents(*before, scene.model, next.descent), next.descent);
    name_elements(*before, scene.model, change->map.elements, next_number);
    changes.push_back(change);
    before = &change->scene.model;
    now = std::move(next.rock);
  }
  for (std::size_t i = changes.size(); i > 1; --i) changes[i - 2]->scene.next = changes[i - 1];
  return changes.empty() ? nullptr : changes.front();
}

}  // namespace keyblock
