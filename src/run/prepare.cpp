// Combines cutting, model and settings into a scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "base/sentences/sentences.hpp"
#include "cut/covers/from_cover.hpp"
#include "legacy/step/hanging.hpp"
#include "model/setup/choose_basis.hpp"
#include "model/setup/from_blocks.hpp"
#include "model/setup/from_manifold.hpp"
#include "model/setup/joint_strength.hpp"
#include "run/ahead/strengths.hpp"
#include "run/ahead/warnings_of_input.hpp"
#include "run/bodies/cover_model.hpp"
#include "run/bodies/edge_loads.hpp"
#include "run/bodies/linear_case.hpp"
#include "run/growth/growth_of.hpp"
#include "run/stages/chain.hpp"
#include "run/stages/cover_stages.hpp"
#include "run/stages/mixed_stages.hpp"
#include "settings/profile.hpp"
#include "settings/setting_row.hpp"
#include "settings/settings_table.hpp"
#include "step/scene/enforcement.hpp"
#include "step/scene/standard_scene.hpp"
#include "system/cholmod/sparse_factor.hpp"

namespace keyblock {
namespace {

// Motions belong to points by their order: a point lost in cutting would give its motion to another.
void require_motions(std::size_t fixed_points, const Analysis& analysis) {
  const std::size_t motions = analysis.fixed_point_motions.size();
  if (motions != 0 && motions != fixed_points)
    throw InputError(analysis.place, fmt::format("expected motions of the {} fixed points of the geometry, found {}",
                                                 fixed_points, motions));
}

/// Result of a geometry before settings apply.
struct Geometry {
  CutResult cut;  ///< no blocks for NMM elements
  Model model;
};

Geometry of_blocks(const Problem& problem, const Settings& settings) {
  CutResult cut = blocks_of(problem, settings);
  if (cut.blocks.blocks.empty()) throw InputError(cut.blocks.place, "expected at least one block, found none");
  require_motions(cut.blocks.fixed_points.size(), *problem.analysis);
  Model model = model_from_blocks(cut.blocks, *problem.analysis);
  return {std::move(cut), std::move(model)};
}

// Shi's step moves each element by the affine field of its three nodes. The exact rotation of each would tear
// neighbours apart.
Model by_old_rules(const Cover& cover, const Analysis& analysis, const Settings& settings) {
  if (settings.rotation == Rotation::exact)
    refuse_value("rotation", "first_order, because NMM elements would part under the other", "exact");
  return with_affine_elements(model_from_manifold(manifold_of(cover), points_of(cover), analysis));
}

// NMM bodies are cut with their slits, and their mesh copes with small ones.
void require_kept_slivers(const Problem& problem, const Settings& settings, const Place& place) {
  if (settings.slivers == Slivers::kept) return;
  if (problem.covers && !problem.covers->mesh.materials.empty()) return;
  throw InputError(place, fmt::format("expected slivers=keep if all bodies are NMM bodies, found {}",
                                      settings.slivers == Slivers::glued ? "glue" : "leave_out"));
}

Geometry on_covers(const Problem& problem, const Settings& settings, const Place& place) {
  require_kept_slivers(problem, settings, place);
  Geometry geometry;
  geometry.cut.blocks.place = place;
  if (problem.covers && !problem.stages.empty()) return geometry;  // each stage has its own
  if (settings.dynamics == Dynamics::standard) {
    CoverModel made = cover_model(problem, settings);
    geometry.cut.warnings = std::move(made.warnings);
    geometry.model = std::move(made.model);
  } else if (const auto* cover = std::get_if<Cover>(&problem.geometry); cover != nullptr && !problem.covers) {
    geometry.model = by_old_rules(*cover, *problem.analysis, settings);
  } else {
    throw InputError(place, "expected profile standard for NMM bodies, found legacy");
  }
  require_motions(geometry.model.fixed_points.size(), *problem.analysis);
  return geometry;
}

bool has_covers(const Problem& problem) {
  return problem.covers || std::holds_alternative<Cover>(problem.geometry);
}

Geometry geometry_of(const Problem& problem, const Settings& settings) {
  if (has_mixed_stages(problem) && !std::holds_alternative<Cover>(problem.geometry)) {
    Geometry geometry;  // each stage has its own model
    geometry.cut = blocks_of(problem, settings);
    require_motions(geometry.cut.blocks.fixed_points.size(), *problem.analysis);
    return geometry;
  }
  if (const auto* cover = std::get_if<Cover>(&problem.geometry)) return on_covers(problem, settings, cover->place);
  if (problem.covers) return on_covers(problem, settings, problem.covers->place);
  return of_blocks(problem, settings);
}

struct Plan {
  Model model;
  Requirements requirements;
  std::shared_ptr<const Groundwork> groundwork = {};
};

// Returns the model with the bases of `standard`, and the plan with the enforcement chosen. Throws InputError for a
// scene that these dynamics cannot run.
Plan standard_plan(Model model, const Settings& settings, const LoadList& loads, const Place& place) {
  model = with_bases(std::move(model), settings.basis);
  put_edge_loads(model, loads);
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
  return {
      scene.model,
      requirements(scene.model, scene.settings, is_automatic ? why_enforcement(scene.model, settings) : std::string()),
      scene.groundwork};
}

Plan plan_of(Model model, const Settings& settings, const LoadList& loads, const Place& place, bool is_untouched) {
  if (is_untouched) {
    model = with_bases(std::move(model), settings.basis);
    Requirements needs = linear_requirements(model, settings);
    return {std::move(model), std::move(needs)};
  }
  if (settings.dynamics == Dynamics::standard) return standard_plan(std::move(model), settings, loads, place);
  if (!loads.empty()) throw InputError(loads.place, "expected profile standard for loads along edges, found legacy");
  model = with_moving_bases(std::move(model), settings.basis);
  Requirements needs = requirements(model, settings);
  return {std::move(model), std::move(needs)};
}

/// Rock after the first stage, and the functions that make models of it and of later rock.
struct Staged {
  ChangedRock first;
  StagedModels models;
};

Staged staged_models(const Problem& problem, const Blocks& blocks, const Place& place, bool is_untouched) {
  const auto finished = [=](Model model, int stage, const Settings& settings) {
    return plan_of(with_joint_strength(std::move(model), settings.joint_strength_factor), settings,
                   acting_in(problem.loads, stage), place, is_untouched)
        .model;
  };
  const Stage& first = problem.stages.front();
  if (has_mixed_stages(problem)) {
    const auto stages = std::make_shared<const MixedStages>(problem);
    return {changed(rock_of(blocks, *problem.analysis), first),
            {[=](const Rock& rock, int stage, const Settings& settings) {
               return finished(stages->model(rock, stage, settings), stage, settings);
             },
             mixed_parents, false}};
  }
  if (!has_covers(problem))
    return {changed(rock_of(blocks, *problem.analysis), first),
            {[=](const Rock& rock, int stage, const Settings& settings) {
               return finished(model_of(rock), stage, settings);
             },
             block_parents, false}};
  const auto stages = std::make_shared<const CoverStages>(problem);
  return {changed(rock_of(stages->bodies(), *problem.analysis), first),
          {[=](const Rock& rock, int stage, const Settings& settings) {
             return finished(stages->model(rock, stage, settings), stage, settings);
           },
           [](const Model& before, const Model& after, const Descent&) { return cover_parents(before, after); },
           is_untouched}};
}

Place place_of(const Problem& problem) {
  if (problem.analysis) return problem.analysis->place;
  if (const auto* drawing = std::get_if<Drawing>(&problem.geometry)) return drawing->place;
  if (const auto* blocks = std::get_if<Blocks>(&problem.geometry)) return blocks->place;
  if (const auto* cover = std::get_if<Cover>(&problem.geometry)) return cover->place;
  return problem.place;
}

/// Request, once it is known whether its steps are linear solutions.
struct Asked {
  Problem problem;
  std::vector<StageChoices> choices;  ///< one per stage, or one
  bool is_untouched = false;
  Warnings warnings = {};
};

Asked as_asked(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides) {
  Asked asked{problem, choices_of_stages(problem, profile, overrides)};
  Settings& settings = asked.choices.front().settings;
  require_linear_tips(problem, settings);
  asked.is_untouched = is_untouched(problem, settings);
  if (asked.is_untouched) {
    LinearCase linear = linear_case(problem, settings);
    settings.ledger = Bookkeeping::off;
    asked.problem = std::move(linear.problem);
    asked.warnings = std::move(linear.warnings);
    asked.choices.resize(std::max<std::size_t>(1, linear.steps.size()), asked.choices.front());
    for (std::size_t i = 0; i < linear.steps.size(); ++i) asked.choices[i].steps = linear.steps[i];
  } else if (problem.covers && problem.covers->contact == CoverContact::ignored) {
    asked.warnings.push_back(
        {"contact_felt", problem.covers->place, "contact is ignored by linear statics only; these steps know it"});
  }
  return asked;
}

/// First scene; later scenes are linked to it.
struct Scenes {
  Scene first;
  Requirements needs;
};

Scenes scenes_in(const Asked& asked, Geometry& geometry, Warnings& warnings) {
  const Problem& problem = asked.problem;
  const Settings& settings = asked.choices.front().settings;
  const Place place = geometry.cut.blocks.place;
  std::optional<Staged> staged;
  if (!problem.stages.empty()) {
    staged = staged_models(problem, geometry.cut.blocks, place, asked.is_untouched);
    geometry.model = staged->models.make(staged->first.rock, 0, settings);
  } else {
    geometry.model = with_joint_strength(std::move(geometry.model), settings.joint_strength_factor);
  }
  auto [model, needs, groundwork] =
      plan_of(std::move(geometry.model), settings, acting_in(problem.loads, 0), place, asked.is_untouched);
  Scene scene{std::move(model), settings};
  scene.groundwork = std::move(groundwork);
  scene.is_untouched = asked.is_untouched;
  if (staged) {
    scene.end = end_of(problem.stages.front(), asked.choices.front());
    warnings = joined(std::move(warnings), staged->first.warnings);
    scene.next = later_scenes(problem, staged->first.rock, scene.model, asked.choices, staged->models, warnings);
  }
  return {std::move(scene), std::move(needs)};
}

void require_one_path(const Scene& first, const Place& place) {
  if (first.settings.standard.load_control == LoadControl::arc_length && (first.next || first.end.steps > 0))
    throw InputError(
        place, "expected a case without stages and excavations under load_control=arc_length, found one with them");
}

Prepared prepared_as_it_is(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides) {
  if (std::holds_alternative<std::monostate>(problem.geometry))
    throw InputError(place_of(problem), "expected a geometry or block file for it, found none");
  if (!problem.analysis)
    throw InputError(place_of(problem),
                     "expected an analysis for it, an analysis file or a case file with the section `analysis`, found "
                     "none; `keyblock new block` writes an example");
  const Asked asked = as_asked(problem, profile, overrides);
  const Settings& settings = asked.choices.front().settings;
  require_readable_strengths(problem, settings);
  Geometry geometry = geometry_of(asked.problem, settings);
  CutResult& cut = geometry.cut;
  Warnings warnings = joined(std::move(cut.warnings), asked.warnings);
  warnings = joined(std::move(warnings), not_modelled(cut.blocks, *problem.analysis, settings));
  auto [scene, needs] = scenes_in(asked, geometry, warnings);
  require_one_path(scene, place_of(problem));
  warnings = joined(std::move(warnings), warnings_of_loads(problem, scene));
  warnings = joined(std::move(warnings), warnings_of_plan(problem, scene));
  warnings = joined(std::move(warnings), without_effect(problem, overrides, scene));
  const Place place = problem.covers ? problem.covers->place : problem.analysis->place;
  warnings = joined(std::move(warnings), warnings_of_strengths(scene, place));
  scene.growth = growth_of(
      problem, scene, [profile, overrides](const Problem& other) { return prepare(other, profile, overrides).scene; });
  const bool was_drawing = std::holds_alternative<Drawing>(problem.geometry);
  return {std::move(cut.blocks),     was_drawing ? std::optional(cut.report) : std::nullopt,
          std::move(cut.snaps),      std::move(warnings),
          std::move(needs),          std::move(scene),
          std::move(cut.joint_lines)};
}

[[noreturn]] void refuse_unseen(const Place& place, const char* found) {
  throw InputError(
      place, fmt::format("expected only loads and supports of `covers` for an error of the mesh, found {}", found));
}

// Rejects input that the mesh by error, found without contact, would ignore.
void require_seen_by_mesh(const Problem& problem) {
  for (const Stage& stage : problem.stages)
    if (!stage.forces.empty() || !stage.held.empty() || !stage.bolts.empty())
      refuse_unseen(stage.place, "forces, held_points or bolts of a stage");
}

// Otherwise points have no effect on the run either.
bool feels_points(const Problem& problem) {
  return problem.covers->contact == CoverContact::felt && problem.covers->excavations.empty();
}

}  // namespace

void tell(const MeshByError& found, Prepared& prepared) {
  if (found.rounds.empty()) return;
  prepared.requirements.basis += "; " + found.sentence();
  prepared.warnings = joined(std::move(prepared.warnings), found.warnings);
}

bool can_prepare(const Problem& problem) {
  return problem.analysis && !std::holds_alternative<std::monostate>(problem.geometry);
}

MeshByError with_mesh_found(const Problem& problem, const std::string& profile,
                            const std::vector<Override>& overrides) {
  if (!has_mesh_by_error(problem) || !problem.analysis) return {problem, {}, {}};
  require_seen_by_mesh(problem);
  return mesh_by_error(problem, [&](const Problem& still, const std::vector<Override>& more) {
    std::vector<Override> all = overrides;
    all.insert(all.end(), more.begin(), more.end());
    const Prepared prepared = prepared_as_it_is(still, profile, all);
    for (const Warning& warning : prepared.warnings)
      if (feels_points(problem) && (warning.name == "points_without_effect" || warning.name == "bolts_without_effect"))
        refuse_unseen(problem.covers->place, "fixed or loading points or bolts");
    return prepared.scene;
  });
}

Prepared prepare(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides) {
  const MeshByError found = with_mesh_found(problem, profile, overrides);
  Prepared prepared = prepared_as_it_is(found.problem, profile, overrides);
  tell(found, prepared);
  return prepared;
}

}  // namespace keyblock
