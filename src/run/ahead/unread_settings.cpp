// Lists each feature that a scene may lack, one per row, with the settings that only it reads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/unread_settings.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <variant>

#include "model/continuum.hpp"
#include "model/material_choices.hpp"
#include "settings/settings_table.hpp"
#include "step/scene/enforcement.hpp"

namespace keyblock {
namespace {

// The only settings that linear statics reads.
constexpr std::array<std::string_view, 8> kReadByLinearStatics{
    "plane", "gravity", "gravity.x", "gravity.y", "steps", "time_step", "motion", "quirk.moments_about_origin"};

struct Reason {
  std::vector<std::string_view> settings;
  bool holds = false;  ///< nothing reads them
  const char* why;
};

/// Returns "mass_damping" from "mass_damping.2".
std::string_view without_material(std::string_view name) {
  const std::size_t point = name.rfind('.');
  const bool has_number = point != std::string_view::npos && point + 1 < name.size() &&
                          std::ranges::all_of(name.substr(point + 1), [](char c) { return c >= '0' && c <= '9'; });
  return has_number ? name.substr(0, point) : name;
}

bool is_loaded_in_steps(const Scene& first) {
  return first.is_untouched && may_yield(first);
}

/// The choice of `automatic` needs all pairs of touching blocks: ask only about settings that springs alone read.
bool has_springs(const Scene& first) {
  return std::ranges::any_of(scenes_of(first), [](const Scene* scene) {
    return has_enforcement(with_enforcement_decided(scene->settings, scene->model), scene->model, Enforcement::penalty);
  });
}

std::vector<Reason> reasons(const Problem& problem, const Scene& first) {
  const std::vector<const Scene*> scenes = scenes_of(first);
  const bool is_static = std::ranges::all_of(
      scenes, [](const Scene* scene) { return scene->settings.standard.motion != MotionRule::dynamic; });
  const bool is_standard = first.settings.dynamics == Dynamics::standard;
  const auto any_element = [&](auto holds) {
    return std::ranges::any_of(scenes,
                               [&](const Scene* scene) { return std::ranges::any_of(scene->model.elements, holds); });
  };
  const bool has_blocks = any_element([](const Element& element) { return !element.is_on_covers(); });
  const bool has_covers = any_element([](const Element& element) { return element.is_on_covers(); });
  return {
      {{"node_merging", "near_pieces"},
       !std::holds_alternative<Drawing>(problem.geometry),
       "is read when a drawing is cut"},
      {{"elastic_law"}, is_standard && !has_covers, "is read for NMM bodies, and there are none"},
      {{"elastic_law"},
       is_standard && !any_element([&](const Element& element) {
         return element.is_on_covers() && !first.model.material_of(element).is_nonlinear();
       }),
       "is read for linear elastic rock: strain of elastoplastic rock, or of rock whose cracks close, is logarithmic"},
      {{"load_control", "path_step"},
       is_standard && !is_loaded_in_steps(first),
       "is read by load steps of elastoplastic NMM bodies without contact"},
      {{"cover_functions"},
       is_standard && !std::holds_alternative<Cover>(problem.geometry),
       "is read for cover files; a case file has its own key `functions`"},
      {{"step_control", "step_tolerance", "least_step_share", "mass_damping", "stiffness_damping", "strain_damping",
        "integrator", "velocity_weight", "force_weight", "newmark_beta", "newmark_gamma", "rho_infinity", "restitution",
        "start"},
       is_standard && is_static,
       "is read by steps in time (motion = dynamic)"},
      {{"velocity_carry_over"}, is_standard && is_static && !has_blocks, "is read by steps in time (motion = dynamic)"},
      {{"basis", "strain_damping", "restitution"},
       is_standard && !has_blocks,
       "is read for blocks, and there are none"},
  };
}

}  // namespace

std::string why_unread(const Problem& problem, const Scene& first, const std::string& name) {
  const bool is_of_load_steps = is_loaded_in_steps(first) && (name == "load_control" || name == "path_step");
  const bool is_of_faces =
      first.model.continuum && first.model.continuum->faces_touch && name == "joint_strength_factor";
  if (first.is_untouched && !is_of_load_steps && !is_of_faces &&
      std::ranges::find(kReadByLinearStatics, name) == kReadByLinearStatics.end())
    return "is not read by linear static solutions";
  for (const Reason& reason : reasons(problem, first))
    if (reason.holds && std::ranges::find(reason.settings, without_material(name)) != reason.settings.end())
      return reason.why;
  if (name == "spring_points" && first.settings.dynamics == Dynamics::standard && !has_springs(first))
    return "is read by contact springs (enforcement = penalty), and there are none";
  return why_unread(first.settings, name);
}

}  // namespace keyblock
