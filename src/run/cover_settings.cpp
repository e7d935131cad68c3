// Parses the settings of a cover plan, one branch per name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/cover_settings.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "cut/mesh/fit_mesh.hpp"
#include "model/cover_basis.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {
namespace {

[[noreturn]] void refuse_setting(const std::string& name, const char* expected, const std::string& value) {
  throw std::invalid_argument(fmt::format("setting {}: expected {}, found \"{}\"", name, expected, value));
}

double number_of(const std::string& name, const char* expected, const std::string& value) {
  double number = 0;
  const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (fault != std::errc() || end != value.data() + value.size() || !std::isfinite(number))
    refuse_setting(name, expected, value);
  return number;
}

void set_one(Problem& problem, const std::pair<std::string, std::string>& setting) {
  const auto& [name, value] = setting;
  set(*problem.covers, name, in_units(problem.units, name, value, measure_of_mesh_setting(name)));
}

// These settings come from the case file: an error in a value is reported there.
void set_plan_as_in_file(Problem& problem) {
  RunChoices& choices = problem.choices;
  RunChoices left = choices;
  left.settings.clear();
  left.setting_places.clear();
  for (std::size_t i = 0; i < choices.settings.size(); ++i) {
    const bool has_place = i < choices.setting_places.size();
    if (!is_of_plan(choices.settings[i].first)) {
      left.settings.push_back(choices.settings[i]);
      if (has_place) left.setting_places.push_back(choices.setting_places[i]);
      continue;
    }
    try {
      set_one(problem, choices.settings[i]);
    } catch (const std::invalid_argument& error) {
      throw InputError(has_place ? choices.setting_places[i] : choices.place, error.what());
    }
  }
  choices = std::move(left);
}

}  // namespace

void set(CoverPlan& plan, const std::string& name, const std::string& value) {
  if (name == "functions") {
    for (const CoverFunctions f :
         {CoverFunctions::constant, CoverFunctions::derived, CoverFunctions::linear, CoverFunctions::quadratic}) {
      if (value != name_of(f)) continue;
      plan.functions = f;
      return;
    }
    refuse_setting(name, "constant, derived, linear or quadratic", value);
  }
  if (name == "contact") {
    if (value != "felt" && value != "ignored") refuse_setting(name, "felt or ignored", value);
    plan.contact = value == "felt" ? CoverContact::felt : CoverContact::ignored;
    return;
  }
  if (name == "mesh.side") {
    plan.mesh.side = number_of(name, "a length above 0", value);
    if (!(plan.mesh.side > 0)) refuse_setting(name, "a length above 0", value);
    plan.mesh.half_rows = 0;
    return;
  }
  if (name == "mesh.half_rows") {
    constexpr const char* kExpected = "a whole number from 1 to 1000";
    const double rows = number_of(name, kExpected, value);
    if (rows != std::floor(rows) || rows < 1 || rows > kMostHalfRows) refuse_setting(name, kExpected, value);
    plan.mesh.kind = MeshKind::regular;
    plan.mesh.half_rows = static_cast<int>(rows);
    plan.mesh.side = 0;
    return;
  }
  if (name == "mesh.angle") {
    plan.mesh.angle_deg = number_of(name, "degrees", value);
    return;
  }
  if (name == "mesh.error") {
    plan.mesh.error = number_of(name, kMeshErrorExpected, value);
    if (!kMeshErrorRange.has(plan.mesh.error)) refuse_setting(name, kMeshErrorExpected, value);
    return;
  }
  if (name == "mesh.most_unknowns") {
    const double most = number_of(name, kMeshLimitExpected, value);
    if (!kMeshLimitRange.has(most) || most != std::floor(most)) refuse_setting(name, kMeshLimitExpected, value);
    plan.mesh.most_unknowns = static_cast<int>(most);
    return;
  }
  throw std::invalid_argument(
      fmt::format("there is no setting \"{}\" of NMM bodies, only functions, contact, mesh.side, mesh.half_rows, "
                  "mesh.angle, mesh.error, mesh.most_unknowns",
                  name));
}

std::optional<Measure> measure_of_mesh_setting(const std::string& name) {
  if (name == "mesh.side") return measures::kLength;
  if (name == "mesh.angle") return measures::kDegrees;
  return std::nullopt;
}

bool is_of_plan(const std::string& name) {
  return name == "functions" || name == "contact" || name.starts_with("mesh.");
}

std::vector<std::pair<std::string, std::string>> set_plan(
    Problem& problem, const std::vector<std::pair<std::string, std::string>>& overrides) {
  if (!problem.covers) return overrides;
  set_plan_as_in_file(problem);
  std::vector<std::pair<std::string, std::string>> left;
  for (const auto& setting : overrides)
    if (is_of_plan(setting.first))
      set_one(problem, setting);
    else
      left.push_back(setting);
  return left;
}

}  // namespace keyblock
