// Looks up paths of the record in a table; settings and the energy balance have tables of their own.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/record/run_measures.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "formats/tables/run_tables.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;
namespace m = measures;

struct RecordEntry {
  std::string_view path;
  std::string_view title;  ///< empty: the words of the path serve
  Measure measure = m::kNumber;
};

constexpr auto kEntries = std::to_array<RecordEntry>({
    {"profile_because", "Reason for the profile"},
    {"outcome.end", "End of the run"},
    {"outcome.steps", "Steps"},
    {"outcome.time", "Time", m::kTime},
    {"outcome.doubts", "Reasons for doubt"},
    {"outcome.ended_early", "Reason for the early end"},
    {"outcome.motion.state", "Motion at the end"},
    {"outcome.motion.sentences[1]", "Motion in words"},
    {"outcome.motion.sentences[2]", "Displacement in words"},
    {"outcome.motion.kinetic_share", "Kinetic energy over the largest stored energy"},
    {"outcome.motion.fastest.speed", "Greatest speed at the end", m::kVelocity},
    {"outcome.motion.fastest.element", "Fastest block at the end"},
    {"outcome.motion.fastest.x", "Place of the fastest block, x", m::kLength},
    {"outcome.motion.fastest.y", "Place of the fastest block, y", m::kLength},
    {"outcome.motion.farthest.element", "Block moved farthest at the end"},
    {"outcome.motion.farthest.displacement", "Greatest displacement at the end", m::kLength},
    {"outcome.motion.farthest.x", "Place of the block moved farthest, x", m::kLength},
    {"outcome.motion.farthest.y", "Place of the block moved farthest, y", m::kLength},
    {"extremes.greatest_displacement.value", "Greatest displacement", m::kLength},
    {"extremes.greatest_displacement.element", "Block of the greatest displacement"},
    {"extremes.least_principal_stress.value", "Least principal stress", m::kStress},
    {"extremes.least_principal_stress.element", "Block of the least principal stress"},
    {"extremes.greatest_principal_stress.value", "Greatest principal stress", m::kStress},
    {"extremes.greatest_principal_stress.element", "Block of the greatest principal stress"},
    {"extremes.least_area_share.value", "Least share of area left"},
    {"extremes.least_area_share.element", "Block of the least share of area left"},
    {"counts.greatest_penetration", "Deepest overlap", m::kLength},
    {"counts.greatest_residual", "Largest force out of balance, over the load"},
    {"counts.least_dt", "Shortest step", m::kTime},
    {"counts.greatest_dt", "Longest step", m::kTime},
    {"counts.passes", "Iterations"},
    {"counts.most_passes", "Most iterations of a step"},
    {"counts.steps_by_passes[1].steps", "Steps without iterations"},
    {"counts.steps_by_passes[2].steps", "Steps of 1 to 3 iterations"},
    {"counts.steps_by_passes[3].steps", "Steps of 4 to 10 iterations"},
    {"counts.steps_by_passes[4].steps", "Steps of 11 to 40 iterations"},
    {"counts.steps_by_passes[5].steps", "Steps of more than 40 iterations"},
    {"counts.redone_attempts", "Attempts made again"},
    {"counts.fallback_solves", "Solves by the fallback"},
    {"counts.unresolved_parts", "Parts of steps short of their target"},
    {"counts.locked_overlaps", "Overlaps left by impacts"},
    {"counts.greatest_displacement_ratio", "Greatest displacement ratio of a step"},
    {"ledger.closure.energy", "Error of the energy balance"},
    {"ledger.largest_energy", "Largest energy", m::kEnergy},
    {"requirements.unknowns", "Unknowns"},
    {"requirements.basis", "Basis of the unknowns"},
    {"start.misfit", "Force out of balance at the start"},
    {"start.unsolved_steps", "Settling steps without a solution"},
    {"is_static", "Static analysis"},
    {"recorded_every", "Steps between frames"},
    {"stages[].end_time", "", m::kTime},
    {"forces.loads.x", "", m::kForce},
    {"forces.loads.y", "", m::kForce},
    {"forces.loads.moment", "", m::kMoment},
    {"forces.springs.x", "", m::kForce},
    {"forces.springs.y", "", m::kForce},
    {"forces.springs.moment", "", m::kMoment},
    {"forces.supports[].x", "", m::kForce},
    {"forces.supports[].y", "", m::kForce},
    {"forces.supports[].moment", "", m::kMoment},
    {"plastic.area", "", m::kArea},
    {"plastic.plastic_work", "", m::kEnergy},
    {"plastic.greatest_equivalent_plastic_strain.x", "", m::kLength},
    {"plastic.greatest_equivalent_plastic_strain.y", "", m::kLength},
    {"reactions[].driven", "", m::kLength},
    {"reactions[].reaction", "", m::kForce},
    {"reactions[].plateau.since_driven", "", m::kLength},
    {"supports[].x", "", m::kLength},
    {"supports[].y", "", m::kLength},
    {"ledger.momentum_about[]", "", m::kLength},
});

/// Numbers of warnings, doubts and failures, by the end of their path. Others have the unit of what they are compared
/// with, or none.
struct FactEntry {
  std::string_view ending;
  Measure measure;
};

constexpr auto kFacts = std::to_array<FactEntry>({
    {".points[][]", m::kLength},
    {".numbers.apart", m::kLength},
    {".numbers.apex", m::kStress},
    {".numbers.area", m::kArea},
    {".numbers.bolt_strength", m::kForce},
    {".numbers.cohesion", m::kStress},
    {".numbers.displacement", m::kLength},
    {".numbers.distance", m::kLength},
    {".numbers.dt", m::kTime},
    {".numbers.farthest", m::kLength},
    {".numbers.gap", m::kLength},
    {".numbers.gravity", m::kAcceleration},
    {".numbers.height", m::kLength},
    {".numbers.length", m::kLength},
    {".numbers.off", m::kLength},
    {".numbers.penetration", m::kLength},
    {".numbers.plastic_work", m::kEnergy},
    {".numbers.pretension", m::kForce},
    {".numbers.radius", m::kLength},
    {".numbers.tensile_strength", m::kStress},
    {".numbers.unit_weight", m::kForcePerVolume},
    {".numbers.width", m::kLength},
    {".numbers.within", m::kLength},
});

constexpr std::string_view kOfStages = "stages[].";
constexpr std::string_view kSettings = "settings.";
constexpr std::string_view kLedgerEnd = "ledger.end.";

/// Returns null for other paths.
const RecordEntry* entry_at(std::string_view path) {
  const auto* const found = std::ranges::find(kEntries, path, &RecordEntry::path);
  return found == kEntries.end() ? nullptr : found;
}

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
  const auto* const fact = std::ranges::find_if(kFacts, [&](const FactEntry& f) { return path.ends_with(f.ending); });
  if (fact != kFacts.end()) return fact->measure;
  const RecordEntry* found = entry_at(path);
  // Quantities of a stage have the keys of those of the whole run.
  if (found == nullptr && path.starts_with(kOfStages))
    found = entry_at(std::string_view(path).substr(kOfStages.size()));
  return found == nullptr || found->measure == m::kNumber ? std::nullopt : std::optional(found->measure);
}

std::string title_in_record(std::string_view path) {
  const RecordEntry* found = entry_at(path);
  return found == nullptr ? std::string() : std::string(found->title);
}

Json units_of_numbers(const Json& record, const Units& units) {
  Json found = Json::object();
  collect(record, "", units, found);
  return found;
}

}  // namespace keyblock
