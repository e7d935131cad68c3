// Looks for input without effect, and for loads, plans and strengths that are likely mistakes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/warnings_of_input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/sentences/sentences.hpp"
#include "base/words/quoted_name.hpp"
#include "run/ahead/strengths.hpp"
#include "run/ahead/unread_settings.hpp"
#include "run/bodies/agreement.hpp"
#include "run/bodies/edge_loads.hpp"
#include "run/bodies/look_at_plan.hpp"
#include "run/stages/chain.hpp"

namespace keyblock {
namespace {

// Relative tolerance of unit weights, which are often derived by hand from a density and a rounded gravity.
constexpr double kSameWeight = 1e-3;

Warning broken_at_start(const BlockBolt& bolt, std::ptrdiff_t number, const Place& place) {
  Facts facts{{{"bolt", number}, {"pretension", bolt.pretension}, {"bolt_strength", bolt.strength}},
              {{"named", quoted_name(bolt.name.value_or({}))}},
              {bolt.first_block + 1, bolt.second_block + 1}};
  if (bolt.name) facts.names = {{"bolt", *bolt.name}};
  return warning_of({"bolt_broken_at_start", std::move(facts)}, place);
}

}  // namespace

Warnings not_modelled(const Blocks& blocks, const Analysis& analysis, const Settings& settings) {
  Warnings warnings;
  const auto warn = [&](const char* name, const std::string& sentence) {
    warnings.push_back({name, analysis.place, sentence});
  };
  const auto has_strength = [](const BlockBolt& bolt) { return bolt.strength > 0; };
  if (settings.dynamics == Dynamics::shi && std::ranges::any_of(blocks.bolts, has_strength))
    warn("bolt_strength_without_effect", "the strength of bolts has no effect, as in the Berkeley program");
  const auto is_overdrawn = [](const BlockBolt& bolt) { return bolt.strength > 0 && bolt.pretension >= bolt.strength; };
  if (const auto bolt = std::ranges::find_if(blocks.bolts, is_overdrawn);
      settings.dynamics == Dynamics::standard && bolt != blocks.bolts.end())
    warnings.push_back(broken_at_start(*bolt, bolt - blocks.bolts.begin() + 1, analysis.place));
  if (analysis.contact_damping != 0)
    warn("contact_damping_without_effect", "the contact damping is read, but has no effect in this profile");
  const auto damped = [](const BlockMaterial& m) { return m.damping != 0; };
  if (std::ranges::any_of(analysis.block_materials, damped))
    warn("damping_without_effect", "the damping of block materials has no effect, as in the Berkeley program");
  const auto has_own_weight = [&](const BlockMaterial& m) {
    return m.unit_weight != 0 &&
           std::abs(m.unit_weight - m.density * settings.file_gravity) > kSameWeight * std::abs(m.unit_weight);
  };
  if (settings.quirks.weight_of_first_material && std::ranges::any_of(analysis.block_materials, has_own_weight))
    warn("unit_weight_without_effect",
         "some unit weight is not density times gravity; as in the Berkeley program, density times gravity is used "
         "(quirk.weight_of_first_material=off takes the unit weights)");
  const auto is_thrown = [](const BlockMaterial& m) { return m.initial_velocity != Velocity{}; };
  const bool takes_slots = settings.quirks.start_velocity_slots && analysis.dialect != AnalysisDialect::ddaml;
  if (takes_slots && std::ranges::any_of(analysis.block_materials, is_thrown))
    warn("initial_velocity_without_effect",
         "initial velocities are read, but blocks do not start with them: as in the Berkeley program they start with "
         "the "
         "values of the stress gradient (quirk.start_velocity_slots=off, or dialect ddaml of a case file, takes the "
         "velocities)");
  const auto is_strained = [](const BlockMaterial& m) { return m.initial_strain != std::array<double, 3>{}; };
  if (std::ranges::any_of(analysis.block_materials, is_strained))
    warn("initial_strain_without_effect", "initial strains have no effect, as in the Berkeley program");
  const auto is_pushed = [](const BlockMaterial& m) { return m.horizontal_force != 0; };
  if (!blocks.blocks.empty() && std::ranges::any_of(analysis.block_materials, is_pushed))
    warn("horizontal_force_without_effect", "horizontal body forces are read, but act on elements of a cover only");
  if (analysis.over_relaxation)
    warn("over_relaxation_without_effect", "the over-relaxation factor is read; the equations are solved directly");
  return warnings;
}

Warnings without_effect(const Problem& problem, const std::vector<Override>& overrides, const Scene& first) {
  Warnings warnings;
  const auto look = [&](const Override& setting, const Place& place) {
    const std::string why = why_unread(problem, first, setting.first);
    if (why.empty()) return;
    Facts facts{{}, {{"why", why}}};
    facts.names = {{"setting", setting.first}};
    warnings.push_back(warning_of({"setting_without_effect", std::move(facts)}, place));
  };
  const RunChoices& choices = problem.choices;
  for (std::size_t i = 0; i < choices.settings.size(); ++i)
    look(choices.settings[i], i < choices.setting_places.size() ? choices.setting_places[i] : problem.analysis->place);
  for (const Stage& stage : problem.stages)
    for (const Override& setting : stage.settings) look(setting, stage.place);
  for (const Override& setting : overrides) look(setting, problem.analysis->place);
  return warnings;
}

Warnings warnings_of_loads(const Problem& problem, const Scene& first) {
  return look_at_loads(problem.loads, scenes_of(first));
}

Warnings warnings_of_plan(const Problem& problem, const Scene& first) {
  if (!problem.covers) return {};
  std::vector<const Continuum*> bodies;
  for (const Scene* scene : scenes_of(first))
    if (scene->model.continuum) bodies.push_back(scene->model.continuum.get());
  if (!first.is_untouched) require_agreement(*problem.covers, first.model);
  return look_at_plan(*problem.covers, bodies);
}

Warnings warnings_of_strengths(const Scene& first, const Place& place) {
  Warnings warnings;
  for (const Scene* scene : scenes_of(first))
    for (const Warning& found : look_at_strengths(*scene, place))
      if (std::ranges::none_of(warnings, [&](const Warning& said) {
            return said.name == found.name && said.sentence == found.sentence;
          }))
        warnings.push_back(found);
  return warnings;
}

}  // namespace keyblock
