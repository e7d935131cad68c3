// Reads the inputs again and describes their materials, with library values and defaults filled in.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/material_tables.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "api/case_values.hpp"
#include "base/bytes/file_bytes.hpp"
#include "base/bytes/sha256.hpp"
#include "base/error.hpp"
#include "base/words/plain_number.hpp"
#include "formats/case.hpp"
#include "problem/units/readable.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

constexpr int kDigitsOfMaterial = 4;

std::string name_of(const std::vector<std::string>& names, std::size_t i) {
  return i < names.size() && !names[i].empty() ? names[i] : fmt::format("{}", i + 1);
}

std::string surface_in_words(YieldSurface surface) {
  switch (surface) {
    case YieldSurface::tresca:
      return "Tresca";
    case YieldSurface::von_mises:
      return "von Mises";
    case YieldSurface::mohr_coulomb:
      return "Mohr-Coulomb";
    case YieldSurface::drucker_prager:
      return "Drucker-Prager";
  }
  return "";
}

// Describes what makes a rock more than elastic.
std::string strength_in_words(const BlockMaterial& rock, const Units& units) {
  std::string text;
  if (rock.strength) {
    const StrengthValues& values = rock.strength->values;
    text = surface_in_words(rock.strength->surface);
    if (rock.strength->surface == YieldSurface::von_mises)
      text += ", yield stress " + readable(values.yield_stress, measures::kStress, units);
    else
      text += ", cohesion " + readable(values.cohesion, measures::kStress, units);
    if (values.friction_deg > 0) text += fmt::format(", friction {}°", plain(values.friction_deg));
    if (values.dilation_deg > 0) text += fmt::format(", dilation {}°", plain(values.dilation_deg));
    if (values.tensile_strength)
      text += ", tensile strength " + readable(*values.tensile_strength, measures::kStress, units);
    if (rock.strength->change) text += ", changes with plastic strain";
  }
  if (rock.crack_closure) text += std::string(text.empty() ? "" : "; ") + "cracks that close";
  if (rock.toughness)
    text += std::string(text.empty() ? "" : "; ") + "toughness " +
            readable(rock.toughness->mode_1, measures::kToughness, units);
  return text.empty() ? "elastic" : text;
}

// Returns the downward gravity of the record, or else that of the case.
double gravity_of(const ResultRecord& record, const Analysis& analysis) {
  const Json& upward = member(record.at("settings"), "gravity.y");
  return upward.is_number() ? 0 - upward.get<double>() : analysis.gravity.value_or(0);  // not -0
}

report::DocumentTable rocks_of(const Analysis& analysis, const std::vector<std::string>& names,
                               const ResultRecord& record) {
  const Units& units = record.units();
  const double gravity = gravity_of(record, analysis);
  Rows rows;
  for (std::size_t i = 0; i < analysis.block_materials.size(); ++i) {
    const BlockMaterial& rock = analysis.block_materials[i];
    rows.push_back(
        {name_of(names, i), readable(rock.density, measures::kDensity, units),
         readable(rock.unit_weight != 0 ? rock.unit_weight : rock.density * gravity, measures::kForcePerVolume, units),
         readable(rock.youngs_modulus, measures::kStress, units), plain(rock.poissons_ratio, kDigitsOfMaterial),
         strength_in_words(rock, units)});
  }
  return {{"rock", "density", "unit weight", "Young's modulus", "Poisson's ratio", "behaviour"}, rows};
}

report::DocumentTable joints_of(const Analysis& analysis, const std::vector<std::string>& names, const Units& units) {
  Rows rows;
  for (std::size_t i = 0; i < analysis.joint_materials.size(); ++i) {
    const JointMaterial& joint = analysis.joint_materials[i];
    rows.push_back({name_of(names, i), plain(joint.friction_angle_deg, kDigitsOfMaterial) + "°",
                    readable(joint.cohesion, measures::kStress, units),
                    readable(joint.tensile_strength, measures::kStress, units)});
  }
  return {{"joint", "friction angle", "cohesion", "tensile strength"}, rows};
}

// Returns the values of the case that were changed after reading.
std::vector<ChangedValue> changed_values(const ResultRecord& record) {
  std::vector<ChangedValue> values;
  if (const Json& changed = record.at("values"); changed.is_object())
    for (const auto& [pointer, value] : changed.items())
      values.push_back({pointer, value.is_string() ? value.get<std::string>() : value.dump()});
  return values;
}

// Returns the files of the case; throws InputError if one is not as it was.
std::vector<std::string> unchanged_inputs(const ResultRecord& record) {
  std::vector<std::string> files;
  const fs::path from = plain_text(record.at("made_by.folder"));  // to which names of files refer
  for (const Json& input : record.list("inputs")) {
    if (input.contains("setting")) continue;
    const std::string name = plain_text(member(input, "file"));
    const std::string file = fs::is_regular_file(from / name) ? (from / name).string() : name;
    if (!fs::is_regular_file(file)) throw InputError({file}, "expected the input file of this result, found none");
    if (sha256(file_bytes(file)) != plain_text(member(input, "sha256")))
      throw InputError({file}, "expected the file as it was read, found another content");
    files.push_back(file);
  }
  return files;
}

}  // namespace

report::DocumentSection material_section(const ResultRecord& record) {
  report::DocumentSection section{"Materials"};
  if (record.list("inputs").empty()) return section;
  try {
    formats::Case input = formats::load_case(unchanged_inputs(record));
    if (const std::vector<ChangedValue> values = changed_values(record); !values.empty())
      input = with_values(input, values);
    const formats::MaterialNames names = formats::names_of(input.files);
    if (!input.problem.analysis) return section;
    const Analysis& analysis = *input.problem.analysis;
    section.paragraphs.push_back("Values of the input files, with defaults and library values filled in.");
    for (report::DocumentTable table :
         {rocks_of(analysis, names.rocks, record), joints_of(analysis, names.joints, record.units())})
      if (!table.rows.empty()) section.tables.push_back(std::move(table));
  } catch (const std::exception& error) {
    section.paragraphs.push_back(fmt::format("Not listed: {}", error.what()));
  }
  return section;
}

}  // namespace keyblock
