// Prepares a case without its mesh by error, and scales its step, mesh and springs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/trade/design_base.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <variant>

#include "model/cover_basis.hpp"
#include "settings/profile.hpp"
#include "study/cases/compared_values.hpp"

namespace keyblock::study {

DesignBase base_of(const StudyCase& chosen, const std::string& profile, const std::vector<Override>& more) {
  DesignBase base;
  ConfiguredCase made = configured_under(profile, chosen, chosen.input.problem, more);
  Problem& problem = made.problem;
  base.has_plan = problem.covers.has_value();
  base.has_cover_file = std::holds_alternative<Cover>(problem.geometry);
  base.has_blocks = !base.has_cover_file && !(base.has_plan && problem.covers->mesh.materials.empty());
  if (base.has_plan) {
    base.plan = *problem.covers;
    base.plan.functions = functions_of(*problem.covers, problem.analysis->block_materials);
  }
  if (base.has_plan) problem.covers->mesh.error = 0;  // irrelevant here
  const Scene scene = prepared_case(made).scene;
  base.is_untouched = scene.is_untouched;
  base.settings = scene.settings;
  if (base.settings.standard.motion == MotionRule::dynamic) base.step_factor = step_factor(profile);
  base.blocks = scene.model.elements.size();
  for (const ExpectedValue& e : chosen.expected) base.times.push_back(e.time);
  return base;
}

std::vector<Override> step_overrides(const DesignBase& base, double factor) {
  const Settings& own = base.settings;
  int whole = own.step_count;
  for (const double time : base.times) {
    const double steps = time / own.time_step;
    if (steps >= 1 && steps <= own.step_count && std::abs(steps - std::round(steps)) <= kSameInstant)
      whole = std::gcd(whole, static_cast<int>(std::round(steps)));
  }
  const int parts = own.step_count / whole;
  const int steps = parts * std::max(1, static_cast<int>(std::lround(whole / factor)));
  if (steps == own.step_count) return {};
  const int set =
      std::max(1, static_cast<int>(std::lround(steps * base.step_factor)));  // the profile makes `steps` of it
  return {{"time_step", fmt::format("{:.15g}", own.time_step * own.step_count / set)},
          {"steps", fmt::format("{}", set)}};
}

std::string factor_name(const char* of, double factor) {
  return factor >= 1 ? fmt::format("{} x{:g}", of, factor) : fmt::format("{} /{:g}", of, 1 / factor);
}

std::vector<Override> mesh_overrides(const MeshPlan& mesh, double factor) {
  if (mesh.error > 0) {
    if (!kMeshErrorRange.has(mesh.error * factor)) return {};
    return {{"mesh.error", fmt::format("{:.12g}", mesh.error * factor)}};
  }
  if (mesh.side > 0) return {{"mesh.side", fmt::format("{:.12g}", mesh.side * factor)}};
  const int rows = std::max(1, static_cast<int>(std::lround(mesh.half_rows / factor)));
  if (rows == mesh.half_rows) return {};
  return {{"mesh.half_rows", fmt::format("{}", rows)}};
}

const char* word_of(const MeshPlan& mesh) {
  return mesh.error > 0 ? "mesh error" : "side";
}

std::vector<Override> penalty_overrides(const DesignBase& base, double factor) {
  const std::pair<std::string, std::string> penalty{"contact_penalty",
                                                    fmt::format("{:.12g}", base.settings.contact_penalty * factor)};
  if (base.is_standard()) return {{"enforcement", "penalty"}, penalty};
  return {{"penalty_control", "constant"}, penalty};
}

}  // namespace keyblock::study
