// Looks up paths of the record in a table; settings and the energy balance have tables of their own.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_measures.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "formats/tables/run_tables.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;
namespace m = measures;

struct PathMeasure {
  std::string_view path;
  Measure measure;
};

constexpr auto kPaths = std::to_array<PathMeasure>({
    {"outcome.time", m::kTime},
    {"outcome.motion.fastest.speed", m::kVelocity},
    {"outcome.motion.fastest.x", m::kLength},
    {"outcome.motion.fastest.y", m::kLength},
    {"outcome.motion.farthest.displacement", m::kLength},
    {"outcome.motion.farthest.x", m::kLength},
    {"outcome.motion.farthest.y", m::kLength},
    {"extremes.greatest_displacement.value", m::kLength},
    {"extremes.least_principal_stress.value", m::kStress},
    {"extremes.greatest_principal_stress.value", m::kStress},
    {"counts.least_dt", m::kTime},
    {"counts.greatest_dt", m::kTime},
    {"counts.greatest_penetration", m::kLength},
    {"stages[].end_time", m::kTime},
    {"forces.loads.x", m::kForce},
    {"forces.loads.y", m::kForce},
    {"forces.loads.moment", m::kMoment},
    {"forces.springs.x", m::kForce},
    {"forces.springs.y", m::kForce},
    {"forces.springs.moment", m::kMoment},
    {"forces.supports[].x", m::kForce},
    {"forces.supports[].y", m::kForce},
    {"forces.supports[].moment", m::kMoment},
    {"plastic.area", m::kArea},
    {"plastic.plastic_work", m::kEnergy},
    {"plastic.greatest_equivalent_plastic_strain.x", m::kLength},
    {"plastic.greatest_equivalent_plastic_strain.y", m::kLength},
    {"reactions[].driven", m::kLength},
    {"reactions[].reaction", m::kForce},
    {"reactions[].plateau.since_driven", m::kLength},
    {"supports[].x", m::kLength},
    {"supports[].y", m::kLength},
    {"ledger.largest_energy", m::kEnergy},
    {"ledger.momentum_about[]", m::kLength},
});

constexpr std::string_view kOfStages = "stages[].";
constexpr std::string_view kSettings = "settings.";
constexpr std::string_view kLedgerEnd = "ledger.end.";

void collect(const Json& value, const std::string& path, const Units& units, Json& found) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) collect(inner, path.empty() ? key : path + "." + key, units, found);
  } else if (value.is_array()) {
    for (const Json& item : value) collect(item, path + "[]", units, found);
  } else if (value.is_number()) {
    const std::string unit = unit_of(measure_in_record(path).value_or(m::kNumber), units);
    if (!unit.empty()) found[path] = unit;
  }
}

}  // namespace

std::optional<Measure> measure_in_record(const std::string& path) {
  if (path.starts_with(kSettings)) return measure_of_setting(path.substr(kSettings.size()));
  if (path.starts_with(kLedgerEnd)) return column_of(formats::kLedgerTable, path.substr(kLedgerEnd.size())).measure;
  const auto find = [](std::string_view wanted) { return std::ranges::find(kPaths, wanted, &PathMeasure::path); };
  auto found = find(path);
  // Quantities of a stage have the keys of those of the whole run.
  if (found == kPaths.end() && path.starts_with(kOfStages))
    found = find(std::string_view(path).substr(kOfStages.size()));
  return found == kPaths.end() ? std::nullopt : std::optional(found->measure);
}

Json units_of_numbers(const Json& record, const Units& units) {
  Json found = Json::object();
  collect(record, "", units, found);
  return found;
}

}  // namespace keyblock
