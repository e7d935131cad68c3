// Builds the settings of each profile in one function of the analysis file; the list of these is the table.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/profile.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace keyblock {
namespace {

// One gravity for all, from `Gravaccel` or from material 1 (legacy-formats 3.2).
double berkeley_gravity(const Analysis& analysis) {
  const BlockMaterial& first = analysis.block_materials.front();
  return analysis.gravity.value_or(first.unit_weight / first.density);
}

// g0 of the file, or the penalty factor times the greatest modulus (legacy-formats 3.4); g0 = 0 means "program
// chooses".
double start_penalty(const Analysis& analysis) {
  if (analysis.contact_penalty.value_or(0) > 0) return *analysis.contact_penalty;
  const auto stiffest = std::ranges::max_element(analysis.block_materials, {}, &BlockMaterial::youngs_modulus);
  return analysis.penalty_factor * stiffest->youngs_modulus;
}

// Manifold files state a time increment and a stiffness, which are used unchanged. (This is inferred: under the rules
// that choose both, nine of twelve old files stop.) Their program's velocities are those of the completed step
// (legacy-formats 2.5).
Settings as_in_manifold_files(Settings settings) {
  settings.step_control = StepControl::constant;
  settings.penalty_control = PenaltyControl::constant;
  settings.quirks.velocity_from_coming_step = false;
  settings.quirks.cut_step_stays = false;
  return settings;
}

// Rules of the Berkeley program, quirks included. Shi's own dialect states start velocity and gradient separately, and
// gives each material its own weight, so the two quirks about them are off.
Settings legacy(const Analysis& analysis) {
  Settings settings;
  settings.step_count = analysis.step_count;
  settings.time_step = analysis.time_step;
  settings.step_control = analysis.automatic_time_step ? StepControl::shi : StepControl::constant;
  settings.velocity_carry_over = analysis.velocity_carry_over;
  settings.rotation = analysis.rotation;
  settings.plane = analysis.plane_strain ? Plane::strain : Plane::stress;
  settings.file_gravity = berkeley_gravity(analysis);
  settings.gravity = {0, 0.0 - settings.file_gravity};
  settings.body_acceleration.curve = analysis.body_acceleration;
  settings.contact_penalty = start_penalty(analysis);
  settings.penalty_control = analysis.automatic_penalty ? PenaltyControl::adaptive : PenaltyControl::constant;
  settings.allowed_displacement_ratio = analysis.allowed_displacement_ratio;
  settings.pass_limit = analysis.open_close_limit;
  settings.open_close = analysis.open_close;
  const bool is_berkeleys = analysis.dialect == AnalysisDialect::berkeley || analysis.dialect == AnalysisDialect::ddaml;
  settings.quirks.start_velocity_slots = is_berkeleys;
  settings.quirks.ddaml_slots = analysis.dialect == AnalysisDialect::ddaml;
  settings.quirks.weight_of_first_material = is_berkeleys;
  return analysis.dialect == AnalysisDialect::manifold ? as_in_manifold_files(settings) : settings;
}

// Settings from theory: the file's scene, materials and step, but no rule of Shi's programs. Native files give each
// material its own weight; `Gravaccel` of a DDAML file is one acceleration for all.
Settings standard(const Analysis& analysis) {
  Settings settings = legacy(analysis);
  settings.dynamics = Dynamics::standard;
  settings.node_merging = NodeMerging::nearest_first;
  settings.near_pieces = NearPieces::led_through;
  settings.step_control = StepControl::constant;
  settings.penalty_control = PenaltyControl::constant;
  settings.rotation = Rotation::exact;
  if (analysis.velocity_carry_over == 0) settings.standard.motion = MotionRule::equilibrium;
  settings.quirks = BerkeleyQuirks::none();
  settings.quirks.weight_of_first_material = analysis.gravity.has_value();
  return settings;
}

// Keeps the time of the file, in steps `factor` times as long. Statics has no time: a step is then a state of its own.
Settings with_steps(Settings settings, double factor) {
  if (settings.standard.motion != MotionRule::dynamic || settings.step_count < 1) return settings;
  const int steps = std::max(1, static_cast<int>(std::lround(settings.step_count / factor)));
  settings.time_step *= static_cast<double>(settings.step_count) / steps;
  settings.step_count = steps;
  return settings;
}

// Steps of `standard` stay accurate when they are long. Rigid blocks save little and lose the strains. The factor is
// two: over all cases it takes 0.83 of the time of `standard`. Four takes 1.25, because contacts that close in dense
// assemblies then need more open–close iterations (sum of the runs of legacy_cases). Some scenes gain from four: see
// legacy_cases/fronts.
constexpr double kDraft = 2;
constexpr double kReference = 0.25;

struct Profile {
  const char* name;
  Settings (*settings)(const Analysis&);
  const char* rules;  ///< profile by which cases name it
  double step;        ///< per step of the file or of its override
};

constexpr std::array<Profile, 4> kProfiles{{{"legacy", legacy, "legacy", 1},
                                            {"draft", standard, "standard", kDraft},
                                            {"standard", standard, "standard", 1},
                                            {"reference", standard, "standard", kReference}}};

const Profile& named(const std::string& name) {
  const auto profile = std::ranges::find(kProfiles, name, [](const Profile& p) { return std::string(p.name); });
  if (profile == kProfiles.end())
    throw std::invalid_argument(
        fmt::format("expected a profile, one of {}, found \"{}\"", fmt::join(profile_names(), ", "), name));
  return *profile;
}

}  // namespace

std::vector<std::string> profile_names() {
  std::vector<std::string> names;
  for (const Profile& profile : kProfiles) names.push_back(profile.name);
  return names;
}

std::vector<std::string> rule_names() {
  return {"legacy", "standard"};
}

std::string rules_of(const std::string& name) {
  return named(name).rules;
}

double step_factor(const std::string& name) {
  return named(name).step;
}

Settings profile_settings(const std::string& name, const Analysis& analysis,
                          const std::function<void(Settings&)>& changes) {
  const Profile& profile = named(name);
  Settings settings = profile.settings(analysis);
  if (changes) changes(settings);
  return profile.step == 1 ? settings : with_steps(std::move(settings), profile.step);
}

}  // namespace keyblock
