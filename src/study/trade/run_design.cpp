// Defines levels as settings in the form of `--set`.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/trade/run_design.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <stdexcept>
#include <string_view>

#include "model/cover_basis.hpp"
#include "settings/profile.hpp"
#include "study/trade/design_base.hpp"

namespace keyblock::study {
namespace {

constexpr std::array<double, 3> kCoarser{8, 4, 2};
// Number of blocks above which contacts form assemblies, whose forces are solved to a tolerance.
constexpr std::size_t kManyBlocks = 20;
constexpr int kFinest = 4;  // part of the step or the side

// Links a level to the next coarser one. The first level finer than the case's own refines that.
void add_refinement(Axis& axis, const char* of, double factor, std::vector<Override> set) {
  if (set.empty()) return;
  Level level{factor_name(of, factor), std::move(set), 1 / factor, {}};
  const double before = axis.levels.empty() ? 0 : axis.levels.back().refinement;
  if (factor < 1 && before < 1)
    level.coarser = "";
  else if (!axis.levels.empty())
    level.coarser = axis.levels.back().name;
  axis.levels.push_back(std::move(level));
}

Axis step_axis(const DesignBase& base, int finest) {
  Axis axis{"step", {}};
  const auto add = [&](double factor) { add_refinement(axis, "step", factor, step_overrides(base, factor)); };
  std::ranges::for_each(kCoarser, add);
  for (int part = 2; part <= finest; part *= 2) add(1.0 / part);
  return axis;
}

Axis mesh_axis(const DesignBase& base, int finest) {
  Axis axis{"mesh", {}};
  const auto add = [&](double factor) {
    add_refinement(axis, word_of(base.plan.mesh), factor, mesh_overrides(base.plan.mesh, factor));
  };
  for (const double factor : {4.0, 2.0}) add(factor);
  for (int part = 2; part <= finest; part *= 2) add(1.0 / part);
  return axis;
}

Axis functions_axis(const char* setting, CoverFunctions own) {
  Axis axis{"functions", {}};
  for (const CoverFunctions f :
       {CoverFunctions::constant, CoverFunctions::derived, CoverFunctions::linear, CoverFunctions::quadratic})
    if (f != own) axis.levels.push_back({std::string(name_of(f)), {{setting, std::string(name_of(f))}}});
  return axis;
}

Axis basis_axis(const DesignBase& base) {
  const bool is_rigid = base.settings.basis.common == BlockBasis::rigid;
  const char* other = is_rigid ? "affine" : "rigid";
  return {"basis", {{other, {{"basis", other}}}}};
}

Axis enforcement_axis(const DesignBase& base) {
  Axis axis{"enforcement", {}};
  const Enforcement own = base.settings.standard.enforcement.common;
  if (own != Enforcement::lagrange) axis.levels.push_back({"multipliers", {{"enforcement", "lagrange"}}});
  if (own != Enforcement::penalty) axis.levels.push_back({"springs", {{"enforcement", "penalty"}}});
  if (own != Enforcement::augmented) axis.levels.push_back({"augmented", {{"enforcement", "augmented"}}});
  return axis;
}

Axis penalty_axis(const DesignBase& base) {
  Axis axis{"penalty", {}};
  for (const double factor : {10.0, 0.1})
    axis.levels.push_back({factor_name("penalty", factor), penalty_overrides(base, factor)});
  return axis;
}

// Steps are as long as their error allows, up to eight times the case's.
Axis tolerance_axis(const DesignBase& base) {
  Axis axis{"tolerance", {}};
  std::vector<Override> coarse = step_overrides(base, kCoarser.front());
  for (const char* tolerance : {"1e-2", "1e-3", "1e-4", "1e-5"}) {
    Level level{fmt::format("tolerance {}", tolerance), {{"step_control", "error"}, {"step_tolerance", tolerance}}};
    level.set.insert(level.set.end(), coarse.begin(), coarse.end());
    axis.levels.push_back(std::move(level));
  }
  return axis;
}

Axis integrator_axis(const DesignBase& base) {
  Axis axis{"integrator", {}};
  const Integrator own = base.settings.standard.integrator;
  if (own != Integrator::weighted) axis.levels.push_back({"weighted", {{"integrator", "weighted"}}});
  if (own != Integrator::newmark) axis.levels.push_back({"Newmark", {{"integrator", "newmark"}}});
  if (own != Integrator::generalized_alpha)
    axis.levels.push_back({"generalised alpha", {{"integrator", "generalized_alpha"}}});
  return axis;
}

Axis impact_axis(const DesignBase& base) {
  const bool is_jump = base.settings.standard.impact == ImpactLaw::jump;
  if (is_jump) return {"impact", {{"impact on springs", {{"impact", "springs"}, {"enforcement", "penalty"}}}}};
  return {"impact", {{"impact as a jump", {{"impact", "jump"}}}}};
}

// Levels of the residual of contact forces in assemblies, over the heaviest load on a block; fewer contacts leave none.
Axis forces_axis() {
  Axis axis{"forces", {}};
  for (const char* tolerance : {"1e-3", "1e-4", "1e-9"})
    axis.levels.push_back({fmt::format("forces to {}", tolerance), {{"force_tolerance", tolerance}}});
  return axis;
}

std::vector<Axis> axes_of(const DesignBase& base, int finest) {
  std::vector<Axis> axes;
  if (base.has_plan) axes.push_back(functions_axis("functions", *base.plan.functions));
  if (base.has_plan && base.plan.mesh.refined.empty()) axes.push_back(mesh_axis(base, finest));
  if (base.is_untouched) return axes;
  if (base.has_cover_file && base.is_standard())
    axes.push_back(functions_axis("cover_functions", base.settings.standard.cover_functions));
  if (base.has_blocks) axes.push_back(basis_axis(base));
  axes.push_back(step_axis(base, finest));
  if (base.is_standard()) axes.push_back(enforcement_axis(base));
  axes.push_back(penalty_axis(base));
  const bool is_dynamic = base.settings.standard.motion == MotionRule::dynamic;
  if (!base.is_standard() || !is_dynamic) return axes;
  axes.push_back(tolerance_axis(base));
  axes.push_back(integrator_axis(base));
  axes.push_back(impact_axis(base));
  if (base.blocks >= kManyBlocks) axes.push_back(forces_axis());
  return axes;
}

/// Combines levels of different axes, in the order of the axes.
RunPlan plan_of(const std::string& profile, const std::vector<std::pair<const Axis*, const Level*>>& made) {
  RunPlan plan;
  plan.profile = profile;
  std::string coarser;
  for (const auto& [axis, level] : made) {
    const auto append = [](std::string& text, const char* between, const std::string& more) {
      if (!more.empty()) text += (text.empty() ? "" : between) + more;
    };
    append(plan.name, ", ", level->name);
    append(plan.group, " and ", axis->name);
    append(coarser, ", ", level->coarser.value_or(level->name));
    plan.set.insert(plan.set.end(), level->set.begin(), level->set.end());
    if (level->coarser) plan.growth *= axis->name == "mesh" ? 4 : 1.5;
  }
  if (plan.growth > 1) plan.coarser = coarser.empty() ? profile : coarser;
  return plan;
}

std::vector<RunPlan> with_profiles(const DesignBase& base, const std::string& profile) {
  std::vector<RunPlan> plans{{profile, "profile", profile, {}, {}, 1}};
  for (const std::string& other : profile_names())
    if (other != profile && !(base.is_untouched && rules_of(other) != rules_of(profile)))
      plans.push_back({other, "profile", other, {}, {}, 1});
  return plans;
}

const Axis* named(const std::vector<Axis>& axes, const char* name) {
  const auto found = std::ranges::find(axes, name, [](const Axis& axis) { return axis.name; });
  return found == axes.end() ? nullptr : &*found;
}

std::vector<Axis> only(std::vector<Axis> axes, const std::vector<std::string>& vary) {
  std::vector<std::string> names;
  for (const Axis& axis : axes) names.push_back(axis.name);
  for (const std::string& name : vary)
    if (std::ranges::find(names, name) == names.end())
      throw std::invalid_argument(
          fmt::format("--vary: expected some of {}, found \"{}\"", fmt::join(names, ", "), name));
  if (!vary.empty())
    std::erase_if(axes, [&](const Axis& axis) { return std::ranges::find(vary, axis.name) == vary.end(); });
  return axes;
}

// Pairs worth their time; the second one varies fastest.
constexpr std::array<std::pair<const char*, const char*>, 6> kPairs{{{"functions", "mesh"},
                                                                     {"functions", "step"},
                                                                     {"basis", "step"},
                                                                     {"basis", "enforcement"},
                                                                     {"basis", "tolerance"},
                                                                     {"enforcement", "step"}}};

}  // namespace

std::vector<Axis> axes_of(const StudyCase& chosen, const std::string& profile) {
  return axes_of(base_of(chosen, profile), kFinest);
}

std::vector<RunPlan> usual_design(const StudyCase& chosen, const std::string& profile,
                                  const std::vector<std::string>& vary) {
  const DesignBase base = base_of(chosen, profile);
  const std::vector<Axis> axes = only(axes_of(base, kFinest), vary);
  std::vector<RunPlan> plans = with_profiles(base, profile);
  for (const Axis& axis : axes)
    for (const Level& level : axis.levels) plans.push_back(plan_of(profile, {{&axis, &level}}));
  for (const auto& [first, second] : kPairs) {
    const Axis* one = named(axes, first);
    const Axis* other = named(axes, second);
    if (one == nullptr || other == nullptr) continue;
    for (const Level& a : one->levels)
      for (const Level& b : other->levels) plans.push_back(plan_of(profile, {{one, &a}, {other, &b}}));
  }
  return plans;
}

std::vector<RunPlan> full_design(const StudyCase& chosen, const std::string& profile, std::size_t most,
                                 const std::vector<std::string>& vary) {
  const DesignBase base = base_of(chosen, profile);
  const std::vector<Axis> axes = only(axes_of(base, kFinest), vary);
  std::vector<RunPlan> plans = with_profiles(base, profile);
  std::vector<std::vector<std::pair<const Axis*, const Level*>>> made{{}};
  for (const Axis& axis : axes) {
    const std::size_t before = made.size();
    for (const Level& level : axis.levels)
      for (std::size_t i = 0; i < before; ++i) {
        // Both axes choose the step, or both the stiffness of the springs.
        const auto chooses = [&](const char* name) {
          return std::ranges::any_of(made[i], [&](const auto& pair) { return pair.first->name == name; });
        };
        if (axis.name == "tolerance" && chooses("step")) continue;
        if (axis.name == "penalty" && chooses("enforcement")) continue;
        made.push_back(made[i]);
        made.back().emplace_back(&axis, &level);
      }
  }
  for (const auto& levels : made)
    if (!levels.empty() && plans.size() < most) plans.push_back(plan_of(profile, levels));
  return plans;
}

std::vector<RunPlan> refinements(const StudyCase& chosen, const std::string& profile, int finest) {
  const DesignBase base = base_of(chosen, profile);
  const Axis axis = base.is_untouched ? mesh_axis(base, finest) : step_axis(base, finest);
  std::vector<RunPlan> plans{{profile, "profile", profile, {}, {}, 1}};
  for (const Level& level : axis.levels)
    if (level.refinement > 1) plans.push_back(plan_of(profile, {{&axis, &level}}));
  plans.erase(plans.begin(), plans.end() - std::min<std::ptrdiff_t>(3, std::ssize(plans)));
  return plans;
}

namespace {

/// Settings of a refinement, and the name of its level relative to the case's own under the profile of the plan.
struct Refinement {
  std::string of;  ///< "step", "side", "mesh error", "tolerance"
  std::string name;
  std::vector<Override> set;
};

constexpr double kSameFactor = 1e-6;  // sides are written with twelve digits

// Returns the name of the step or side over the case's own; empty if both are equal.
std::string refinement_name(const char* of, double factor) {
  return std::abs(factor - 1) <= kSameFactor ? "" : factor_name(of, factor);
}

Refinement refinement_of(const DesignBase& own, const DesignBase& now, int parts) {
  if (now.is_untouched) {
    const std::vector<Override> set = mesh_overrides(now.plan.mesh, 1.0 / parts);
    const MeshPlan& was = own.plan.mesh;
    const MeshPlan& is = now.plan.mesh;
    const double factor = was.error > 0  ? is.error / was.error
                          : was.side > 0 ? is.side / was.side
                                         : static_cast<double>(was.half_rows) / is.half_rows;
    return {word_of(was), refinement_name(word_of(was), factor / parts), set};
  }
  if (now.settings.step_control == StepControl::error) {
    const std::string tolerance = fmt::format("{:.2g}", now.settings.standard.step_tolerance / parts);
    return {"tolerance", "tolerance " + tolerance, {{"step_tolerance", tolerance}}};
  }
  const double factor = static_cast<double>(own.settings.step_count) / now.settings.step_count / parts;
  return {"step", refinement_name("step", factor), step_overrides(now, 1.0 / parts)};
}

// Returns the levels joined in a name, without that of the step: "rigid" and "springs" of "rigid, step /4, springs".
std::vector<std::string> other_levels(const std::string& name, const std::string& of) {
  std::vector<std::string> levels;
  for (const auto part : std::views::split(name, std::string_view(", "))) {
    std::string level(part.begin(), part.end());
    if (!level.starts_with(of + ' ')) levels.push_back(std::move(level));
  }
  return levels;
}

}  // namespace

std::optional<RunPlan> refined(const StudyCase& chosen, const std::string& profile, const RunPlan& plan, int parts) {
  const DesignBase now = base_of(chosen, plan.profile, plan.set);
  const Refinement finer = refinement_of(base_of(chosen, plan.profile), now, parts);
  if (finer.set.empty()) return std::nullopt;
  RunPlan made = plan;
  std::vector<std::string> levels = other_levels(plan.name == profile ? "" : plan.name, finer.of);
  if (!finer.name.empty()) levels.push_back(finer.name);
  made.name = levels.empty() ? profile : fmt::format("{}", fmt::join(levels, ", "));
  made.group = plan.group == "profile" ? finer.of : plan.group;
  made.coarser = plan.name;
  made.growth = 1.5;
  for (const Override& setting : finer.set) {
    std::erase_if(made.set, [&](const Override& old) { return old.first == setting.first; });
    made.set.push_back(setting);
  }
  return made;
}

std::vector<RunPlan> penalty_step_map(const StudyCase& chosen, const std::string& profile,
                                      const std::vector<double>& penalties, const std::vector<double>& steps) {
  const DesignBase base = base_of(chosen, profile);
  if (base.is_untouched)
    throw std::invalid_argument("a linear static case of NMM bodies has neither contact stiffness nor steps");
  std::vector<RunPlan> plans;
  for (const double penalty : penalties)
    for (const double step : steps) {
      RunPlan plan{fmt::format("{}, {}", factor_name("penalty", penalty), factor_name("step", step)),
                   "penalty and step",
                   profile,
                   penalty_overrides(base, penalty),
                   {},
                   1};
      const std::vector<Override> set = step_overrides(base, step);
      plan.set.insert(plan.set.end(), set.begin(), set.end());
      plans.push_back(std::move(plan));
    }
  return plans;
}

}  // namespace keyblock::study
