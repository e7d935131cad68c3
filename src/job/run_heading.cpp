// Reads title, units and lists of elements from the record that run_report.cpp wrote.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_heading.hpp"

#include <fmt/format.h>

#include "base/bytes/file_bytes.hpp"
#include "base/bytes/sound_json.hpp"
#include "base/error.hpp"
#include "job/folder/output_files.hpp"
#include "problem/units/measure.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

const Json& member(const Json& of, const char* key) {
  static const Json kNone;
  const auto found = of.is_object() ? of.find(key) : of.end();
  return found == of.end() ? kNone : *found;
}

std::string text(const Json& of, const char* key) {
  const Json& found = member(of, key);
  return found.is_string() ? found.get<std::string>() : std::string();
}

/// Returns the numbers under a key, from 0.
std::vector<int> numbers(const Json& of, const char* key) {
  std::vector<int> found;
  for (const Json& number : member(of, key))
    if (number.is_number_integer()) found.push_back(number.get<int>() - 1);
  return found;
}

}  // namespace

std::string title_of(const std::filesystem::path& file, const std::string& profile) {
  return fmt::format("{}, profile {}", file.stem().string(), profile);
}

std::string title_at(const std::string& title, double time, const Units& units) {
  return fmt::format("{}, time {:g}{}{}", title, time, units.time.empty() ? "" : " ", units.time);
}

Json units_by_letters(const Units& units) {
  namespace m = measures;
  Json found = Json::object();
  for (const Measure& measure :
       {m::kRadians,        m::kLength,       m::kArea,          m::kTime,      m::kVelocity,
        m::kAcceleration,   m::kRotationRate, m::kRate,          m::kStress,    m::kDensity,
        m::kForcePerVolume, m::kToughness,    m::kEnergyPerArea, m::kMass,      m::kMomentOfInertia,
        m::kForce,          m::kMoment,       m::kEnergy,        m::kStiffness, m::kMomentum,
        m::kAngularMomentum})
    if (is_declared(measure, units))
      found[unit_of(measure, {}) + (measure.of_slice ? " of a slice" : "")] = unit_of(measure, units);
  return found;
}

Json units_json(const Units& units) {
  Json json = {{"length", units.length}, {"mass", units.mass}, {"time", units.time}};
  if (is_declared(measures::kForce, units)) json["force"] = unit_of(Measure{{1, 1, -2}}, units);
  if (is_declared(measures::kStress, units)) json["stress"] = unit_of(measures::kStress, units);
  return json;
}

RunHeading heading_of(const std::filesystem::path& folder) {
  RunHeading heading{std::filesystem::absolute(folder / ".").lexically_normal().parent_path().filename().string()};
  const std::filesystem::path file = folder / kRecord;
  if (!std::filesystem::is_regular_file(file)) return heading;
  const Json record = sound_json(file_bytes(file.string()));
  if (!record.is_object()) throw InputError({file.string()}, "expected the record of a run (JSON), found another file");
  const Json& inputs = member(record, "inputs");
  const std::string first = inputs.is_array() && !inputs.empty() ? text(inputs[0], "file") : std::string();
  const std::string profile = text(record, "profile");
  if (!first.empty() && !profile.empty()) heading.title = title_of(first, profile);
  const Json& units = member(record, "units");
  heading.units = {text(units, "length"), text(units, "mass"), text(units, "time")};
  heading.is_of_motion = member(record, "is_of_motion") != false;
  heading.left_out = numbers(record, "left_out");
  heading.held = numbers(record, "held");
  return heading;
}

}  // namespace keyblock
