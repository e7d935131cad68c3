// Cutting, model and settings put together.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/prepare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "cut/covers/from_cover.hpp"
#include "legacy/step/hanging.hpp"
#include "model/setup/choose_basis.hpp"
#include "model/setup/from_blocks.hpp"
#include "model/setup/from_manifold.hpp"
#include "model/setup/joint_strength.hpp"
#include "run/bodies/cover_model.hpp"
#include "run/bodies/planned_bodies.hpp"
#include "run/stages/chain.hpp"
#include "run/stages/cover_stages.hpp"
#include "run/unread_settings.hpp"
#include "settings/profile.hpp"
#include "settings/setting_row.hpp"
#include "settings/settings_table.hpp"
#include "step/scene/enforcement.hpp"
#include "step/scene/standard_scene.hpp"
#include "system/sparse_factor.hpp"

namespace keyblock {
namespace {

// Unit weights are written by hand from a density and a rounded gravity: within a thousandth they are the same.
constexpr double kSameWeight = 1e-3;

// What the files ask for that this profile does not do is said, not dropped in silence.
Warnings not_modelled(const Blocks& blocks, const Analysis& analysis, const Settings& settings) {
  Warnings warnings;
  const auto warn = [&](const char* name, const char* sentence) {
    warnings.push_back({name, analysis.place, sentence});
  };
  const auto has_strength = [](const BlockBolt& bolt) { return bolt.strength > 0; };
  if (settings.dynamics == Dynamics::shi && std::ranges::any_of(blocks.bolts, has_strength))
    warn("bolt_strength_without_effect", "the strength of bolts is read, but breaks none, as in the old program");
  if (analysis.contact_damping != 0)
    warn("contact_damping_without_effect", "the contact damping is read, but has no effect in this profile");
  const auto damped = [](const BlockMaterial& m) { return m.damping != 0; };
  if (std::ranges::any_of(analysis.block_materials, damped))
    warn("damping_without_effect",
         "the damping of block materials is read, but has no effect, as in the old program; --set mass_damping.N or "
         "stiffness_damping.N for block material N has one");
  const auto has_own_weight = [&](const BlockMaterial& m) {
    return std::abs(m.unit_weight - m.density * settings.file_gravity) > kSameWeight * std::abs(m.unit_weight);
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
    warn("initial_strain_without_effect", "initial strains are read, but move nothing, as in the old program");
  const auto is_pushed = [](const BlockMaterial& m) { return m.horizontal_force != 0; };
  if (!blocks.blocks.empty() && std::ranges::any_of(analysis.block_materials, is_pushed))
    warn("horizontal_force_without_effect", "horizontal body forces are read, but act on elements of a cover only");
  if (analysis.over_relaxation)
    warn("over_relaxation_without_effect", "the over-relaxation factor is read; the equations are solved directly");
  return warnings;
}

// Settings of the case file, of its stages and of the command.
Warnings without_effect(const Problem& problem, const std::vector<Override>& overrides, const Scene& first) {
  std::vector<Override> all = problem.choices.settings;
  for (const Stage& stage : problem.stages) all.insert(all.end(), stage.settings.begin(), stage.settings.end());
  all.insert(all.end(), overrides.begin(), overrides.end());
  Warnings warnings;
  for (const auto& [name, value] : all) {
    const std::string why = why_unread(problem, first, name);
    if (why.empty()) continue;
    warnings.push_back({"setting_without_effect", problem.analysis->place,
                        fmt::format("setting {} {} and has no effect here", name, why)});
  }
  return warnings;
}

// Motions belong to points by their order: a point lost in cutting would give its motion to another.
void require_motions(std::size_t fixed_points, const Analysis& analysis) {
  const std::size_t motions = analysis.fixed_point_motions.size();
  if (motions != 0 && motions != fixed_points)
    throw InputError(analysis.place, fmt::format("expected motions of the {} fixed points of the geometry, found {}",
                                                 fixed_points, motions));
}

/// What a geometry becomes, before settings look at it.
struct Geometry {
  CutResult cut;  ///< no blocks where elements hang on covers
  Model model;
};

Geometry of_blocks(const Problem& problem, const Settings& settings) {
  CutResult cut = blocks_of(problem, settings);
  if (cut.blocks.blocks.empty()) throw InputError(cut.blocks.place, "expected at least one block, found none");
  require_motions(cut.blocks.fixed_points.size(), *problem.analysis);
  Model model = model_from_blocks(cut.blocks, *problem.analysis);
  return {std::move(cut), std::move(model)};
}

// The old step moves elements each by the affine field of its three nodes. The exact rotation of each would tear
// neighbours apart.
Model by_old_rules(const Cover& cover, const Analysis& analysis, const Settings& settings) {
  if (settings.rotation == Rotation::exact)
    refuse_value("rotation", "first_order, for elements on covers would part under the other", "exact");
  return with_affine_elements(model_from_manifold(manifold_of(cover), points_of(cover), analysis));
}

Geometry on_covers(const Problem& problem, const Settings& settings, const Place& place) {
  Geometry geometry;
  geometry.cut.blocks.place = place;
  if (settings.dynamics == Dynamics::standard) {
    CoverModel made = cover_model(problem, settings);
    geometry.cut.warnings = std::move(made.warnings);
    geometry.model = std::move(made.model);
  } else if (const auto* cover = std::get_if<Cover>(&problem.geometry)) {
    geometry.model = by_old_rules(*cover, *problem.analysis, settings);
  } else {
    throw InputError(place, "expected profile standard for bodies on covers, found legacy");
  }
  require_motions(geometry.model.fixed_points.size(), *problem.analysis);
  return geometry;
}

Geometry geometry_of(const Problem& problem, const Settings& settings) {
  if (const auto* cover = std::get_if<Cover>(&problem.geometry)) return on_covers(problem, settings, cover->place);
  if (problem.covers) return on_covers(problem, settings, problem.covers->place);
  return of_blocks(problem, settings);
}

struct Plan {
  Model model;
  Requirements requirements;
};

// The model with the bases of `standard`, and the plan with the enforcement that was decided on. Throws InputError for
// a scene that these dynamics cannot run.
Plan standard_plan(Model model, const Settings& settings, const Place& place) {
  model = with_bases(std::move(model), settings.basis);
  const StandardScene scene = [&] {
    try {
      return standard_scene(model, settings);
    } catch (const NotPositiveDefinite&) {
      throw InputError(place,
                       "expected covers that all carry mass, found some cut so thin that their mass is lost in "
                       "round-off: another mesh, or --absorb, avoids them");
    }
  }();
  const std::string why = unsupported(scene);
  if (!why.empty()) throw InputError(place, why);
  const bool is_automatic = settings.standard.enforcement.common == Enforcement::automatic;
  return {scene.model, requirements(scene.model, scene.settings,
                                    is_automatic ? why_enforcement(scene.model, settings) : std::string())};
}

Plan plan_of(Model model, const Settings& settings, const Place& place) {
  if (settings.dynamics == Dynamics::standard) return standard_plan(std::move(model), settings, place);
  model = with_moving_bases(std::move(model), settings.basis);
  Requirements needs = requirements(model, settings);
  return {std::move(model), std::move(needs)};
}

/// The rock as the first stage leaves it, and how models are made of it and of those to come.
struct Staged {
  ChangedRock first;
  StagedModels models;
};

Staged staged_models(const Problem& problem, const Blocks& blocks, const Place& place) {
  const auto finished = [place](Model model, const Settings& settings) {
    return plan_of(with_joint_strength(std::move(model), settings.joint_strength_factor), settings, place).model;
  };
  const Stage& first = problem.stages.front();
  if (!problem.covers && !std::holds_alternative<Cover>(problem.geometry))
    return {changed(rock_of(blocks, *problem.analysis), first),
            {[=](const Rock& rock, int, const Settings& settings) { return finished(model_of(rock), settings); },
             block_parents}};
  const auto stages = std::make_shared<const CoverStages>(problem);
  return {changed(rock_of(stages->bodies(), *problem.analysis), first),
          {[=](const Rock& rock, int stage, const Settings& settings) {
             return finished(stages->model(rock, stage, settings), settings);
           },
           [](const Model& before, const Model& after, const Descent&) { return cover_parents(before, after); }}};
}

Place place_of(const Problem& problem) {
  if (problem.analysis) return problem.analysis->place;
  if (const auto* drawing = std::get_if<Drawing>(&problem.geometry)) return drawing->place;
  if (const auto* blocks = std::get_if<Blocks>(&problem.geometry)) return blocks->place;
  if (const auto* cover = std::get_if<Cover>(&problem.geometry)) return cover->place;
  return problem.place;
}

}  // namespace

bool has_fixed_or_loading_points(const Problem& problem) {
  const auto has_points = [](const auto& geometry) {
    if constexpr (requires { geometry.fixed_points; })
      return !geometry.fixed_points.empty() || !geometry.loading_points.empty();
    else if constexpr (requires { geometry.fixed_lines; })
      return !geometry.fixed_lines.empty() || !geometry.loading_points.empty();
    else
      return false;
  };
  return std::visit(has_points, problem.geometry);
}

bool has_bolts(const Problem& problem) {
  const auto has = [](const auto& geometry) {
    if constexpr (requires { geometry.bolts; })
      return !geometry.bolts.empty();
    else
      return false;
  };
  return std::visit(has, problem.geometry);
}

bool is_solved_at_once(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides) {
  if (!problem.stages.empty()) return false;
  if (!problem.covers || !problem.analysis) return problem.covers.has_value();
  if (!problem.covers->excavations.empty()) return true;
  const Settings settings = settings_of(problem, profile, overrides);
  const bool is_static = settings.dynamics == Dynamics::standard && settings.standard.motion == MotionRule::equilibrium;
  if (!is_static || !problem.covers->mesh.materials.empty()) return false;
  if (problem.covers->contact == CoverContact::ignored) return true;
  return !has_fixed_or_loading_points(problem) && !has_bolts(problem) && !PlannedBodies(problem).touches();
}

bool can_prepare(const Problem& problem) {
  return problem.analysis && !std::holds_alternative<std::monostate>(problem.geometry);
}

Prepared prepare(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides) {
  if (std::holds_alternative<std::monostate>(problem.geometry))
    throw InputError(place_of(problem), "expected a geometry or block file beside it, found none");
  if (!problem.analysis) throw InputError(place_of(problem), "expected an analysis file beside it, found none");
  const std::vector<StageChoices> choices = choices_of_stages(problem, profile, overrides);
  const Settings& settings = choices.front().settings;
  Geometry geometry = geometry_of(problem, settings);
  CutResult& cut = geometry.cut;
  const Place place = cut.blocks.place;
  std::optional<Staged> staged;
  if (!problem.stages.empty()) {
    staged = staged_models(problem, cut.blocks, place);
    geometry.model = staged->models.make(staged->first.rock, 0, settings);
  }
  cut.warnings = joined(std::move(cut.warnings), not_modelled(cut.blocks, *problem.analysis, settings));
  // Models of stages come with their joint strength.
  if (!staged) geometry.model = with_joint_strength(std::move(geometry.model), settings.joint_strength_factor);
  auto [model, needs] = plan_of(std::move(geometry.model), settings, place);
  Scene scene{std::move(model), settings};
  if (staged) {
    scene.end = end_of(problem.stages.front(), choices.front());
    cut.warnings = joined(std::move(cut.warnings), staged->first.warnings);
    scene.next = later_scenes(problem, staged->first.rock, scene.model, choices, staged->models, cut.warnings);
  }
  cut.warnings = joined(std::move(cut.warnings), without_effect(problem, overrides, scene));
  const bool was_drawing = std::holds_alternative<Drawing>(problem.geometry);
  return {std::move(cut.blocks), was_drawing ? std::optional(cut.report) : std::nullopt,
          std::move(cut.snaps),  std::move(cut.warnings),
          std::move(needs),      std::move(scene)};
}

}  // namespace keyblock
