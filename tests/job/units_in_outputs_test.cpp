// One case in four systems of units: metres and kilograms, metres and kilonewtons, millimetres and tonnes, metres and
// megapascals. Every number of every output is the same, if its unit is taken into account. The values of the case have
// their own units, so that only the section "units" differs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>

#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "problem/units/unit_conversion.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::units_in_outputs_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr double kRelative = 1e-9;
constexpr double kRelativeOfShort = 2e-7;  // of the value: a number of 24 bits, rounded in both systems

struct System {
  const char* name;
  const char* units;
  double metre;  ///< units of length in a metre
};
constexpr std::array<System, 4> kSystems{{{"m_kg_s", R"({"length": "m", "mass": "kg", "time": "s"})", 1},
                                          {"m_kN_s", R"({"length": "m", "force": "kN", "time": "s"})", 1},
                                          {"mm_t_s", R"({"length": "mm", "mass": "t", "time": "s"})", 1000},
                                          {"m_MPa_s", R"({"length": "m", "stress": "MPa", "time": "s"})", 1}}};

// Measure of each column, as a unit of SI; # is a number. Plain numbers are left out.
const std::map<std::string, std::string> kKinds{
    {"time", "s"},
    {"dt", "s"},
    {"x", "m"},
    {"y", "m"},
    {"x#", "m"},
    {"y#", "m"},
    {"dx", "m"},
    {"dy", "m"},
    {"dx#", "m"},
    {"dy#", "m"},
    {"cx", "m"},
    {"cy", "m"},
    {"rot", "rad"},
    {"area", "m2"},
    {"length", "m"},
    {"gap", "m"},
    {"slip", "m"},
    {"greatest_gap", "m"},
    {"greatest_slip", "m"},
    {"bolt#", "N/m"},
    {"reaction#_x", "N/m"},
    {"reaction#_y", "N/m"},
    {"driven#", "m"},
    {"plastic_work", "J/m"},
    {"sxx", "Pa"},
    {"syy", "Pa"},
    {"sxy", "Pa"},
    {"szz", "Pa"},
    {"mean_stress", "Pa"},
    {"von_mises_stress", "Pa"},
    {"lode_angle", "deg"},
    {"normal_force", "N/m"},
    {"shear_force", "N/m"},
    {"force_x", "N/m"},
    {"force_y", "N/m"},
    {"force", "N/m"},
    {"penalty", "N/m/m"},
    {"greatest_penetration", "m"},
    {"max_penetration", "m"},
    {"K_I", "Pa√m"},
    {"K_II", "Pa√m"},
    {"K_eq", "Pa√m"},
    {"toughness", "Pa√m"},
    {"J", "J/m2"},
    {"kink", "deg"},
    {"kinetic", "J/m"},
    {"strain", "J/m"},
    {"gravity", "J/m"},
    {"contact", "J/m"},
    {"external", "J/m"},
    {"friction", "J/m"},
    {"damping", "J/m"},
    {"impact", "J/m"},
    {"closing", "J/m"},
    {"clean_up", "J/m"},
    {"rupture", "J/m"},
    {"algorithmic", "J/m"},
    {"projection", "J/m"},
    {"geometric", "J/m"},
    {"creep", "J/m"},
    {"plastic", "J/m"},
    {"fracture", "J/m"},
    {"change", "J/m"},
    {"momentum_x", "kg·m/s/m"},
    {"momentum_y", "kg·m/s/m"},
    {"angular_momentum", "kg·m²/s/m"},
    {"impulse_x", "N·s/m"},
    {"impulse_y", "N·s/m"},
    {"angular_impulse", "N·m·s/m"},
    {"reaction_impulse_x", "N·s/m"},
    {"reaction_impulse_y", "N·s/m"},
    {"angular_reaction_impulse", "N·m·s/m"},
    {"stress_xx", "Pa"},
    {"stress_yy", "Pa"},
    {"stress_xy", "Pa"},
    {"stress_zz", "Pa"},
    {"principal_stress_greatest", "Pa"},
    {"principal_stress_least", "Pa"},
    {"displacement", "m"},
    {"velocity", "m/s"},
    {"rotation", "rad"},
    {"rotation_rate", "rad/s"},
};
const std::set<std::string> kNumbers{"Stage",
                                     "IsStatic",
                                     "LoadFactor",
                                     "step",
                                     "point",
                                     "block",
                                     "other",
                                     "joint_material",
                                     "joint",
                                     "what",
                                     "name",
                                     "quantity",
                                     "value",
                                     "unit",
                                     "state",
                                     "normal_x",
                                     "normal_y",
                                     "normal",
                                     "contacts",
                                     "closed",
                                     "sliding",
                                     "bolt",
                                     "is_broken",
                                     "load_factor",
                                     "load_share",
                                     "tip",
                                     "crack",
                                     "end",
                                     "goes_on",
                                     "kind",
                                     "side",
                                     "is_shear",
                                     "passes",
                                     "redos",
                                     "fallbacks",
                                     "displacement_ratio",
                                     "disp_ratio",
                                     "residual",
                                     "unsettled_contacts",
                                     "parts",
                                     "oci",
                                     "k_blocks",
                                     "material",
                                     "round",
                                     "yielded_fraction",
                                     "yielding_fraction",
                                     "elastic_strain_xx",
                                     "elastic_strain_yy",
                                     "elastic_strain_xy",
                                     "elastic_strain_zz",
                                     "plastic_strain_xx",
                                     "plastic_strain_yy",
                                     "plastic_strain_xy",
                                     "plastic_strain_zz",
                                     "equivalent_plastic_strain",
                                     "yield_state",
                                     "has_yielded",
                                     "origin",
                                     "body",
                                     "principal_axis",
                                     "fixed_points"};

// A block that slides on a fixed one, bolted to it, pushed, with a third that falls onto it.
const std::string kSliding = R"(
 "blocks": {"blocks": [
   {"material": "rock", "outer": [["0 m", "0 m", 1], ["6 m", "0 m", 1], ["6 m", "1 m", 1], ["0 m", "1 m", 1]]},
   {"material": "rock", "outer": [["1 m", "1 m", 1], ["2.5 m", "1 m", 1], ["2.5 m", "2 m", 1], ["1 m", "2 m", 1]]},
   {"material": "rock", "outer": [["1.2 m", "220 cm", 1], ["2 m", "220 cm", 1], ["2 m", "2.9 m", 1],
     ["1.2 m", "2.9 m", 1]]}],
  "bolts": [["0.5 m", "0.5 m", "1.5 m", "1.5 m", 1, 2, "20 MN/m/m", "2 MN/m", "3 kN/m"]],
  "fixed_points": [["0.1 m", "0.1 m", 1], ["5.9 m", "0.1 m", 1], ["3 m", "0.9 m", 1]],
  "loading_points": [["1.1 m", "1.5 m", 2]], "measured_points": [["2.4 m", "1.9 m", 2], ["1.6 m", "2.5 m", 3]]},
 "analysis": {"velocity_carry_over": 1, "plane_strain": true, "step_count": 60, "time_step": "5 ms",
  "allowed_displacement_ratio": 0.05, "contact_penalty": "0.2 GN/m/m", "gravity": "9.81 m/s2",
  "block_materials": [{"name": "rock", "density": "2600 kg/m3", "youngs_modulus": "100 MPa", "poissons_ratio": 0.2,
    "initial_velocity": ["10 cm/s", "0 m/s", "0 deg/s"]}],
  "joint_materials": [{"friction_angle_deg": "20 deg", "cohesion": "1 kPa"}],
  "point_loads": [[["0 s", "0 N/m", "0 N/m"], ["0.1 s", "20 kN/m", "-5 kN/m"], ["1 min", "20 kN/m", "-5 kN/m"]]]},
 "outputs": {"histories": [{"block": 2}, {"contact": [1, 2]}, {"name": "corner", "point": ["2 m", "150 cm"]},
   {"name": "bed", "line": ["0 m", "1 m", "6 m", "1 m"]}]})";

// A plate with an edge crack that is pulled until it grows.
const std::string kCrack = R"(
 "blocks": {"blocks": [{"outer": [["0 m", "-1 m", 1], ["1 m", "-1 m", 1], ["1 m", "1 m", 1], ["0 m", "1 m", 1]]}]},
 "covers": {"contact": "ignored", "mesh": {"side": "20 cm", "tip_side": "1 cm"},
  "cracks": [{"along": [["0 m", "0 m"], ["0.4 m", "0 m"]]}], "growth": {"increment": "8 cm"},
  "tractions": [{"along": [["0 m", "1 m"], ["1 m", "1 m"]], "y": "1 MPa"},
                {"along": [["0 m", "-1 m"], ["1 m", "-1 m"]], "y": "-1 MPa"}],
  "springs": [["1 m", "-1 m", 1, 0, "20 GN/m/m"], ["1 m", "-1 m", 0, 1, "20 GN/m/m"],
              ["1 m", "1 m", 1, 0, "20 GN/m/m"]]},
 "analysis": {"velocity_carry_over": 0, "plane_strain": true, "step_count": 3, "time_step": "1 s",
  "allowed_displacement_ratio": 0.1, "gravity": 0,
  "block_materials": [{"density": "2600 kg/m3", "unit_weight": 0, "youngs_modulus": "20 GPa", "poissons_ratio": 0.25,
    "toughness": {"mode_1": "1.5 MPa√m"}}],
  "joint_materials": [{}]})";

// A pillar of elastoplastic rock under a lid that is pressed down.
const std::string kPillar = R"(
 "blocks": {"blocks": [{"outer": [["0 m", "0 m", 1], ["1 m", "0 m", 1], ["1 m", "2 m", 1], ["0 m", "2 m", 1]]}],
  "measured_points": [["0.5 m", "1 m", 1]]},
 "covers": {"functions": "constant", "contact": "ignored", "mesh": {"side": "40 cm"},
  "displacements": [{"along": [["0 m", "0 m"], ["1 m", "0 m"]], "held": "both"},
                    {"along": [["1 m", "2 m"], ["0 m", "2 m"]], "held": "y", "y": "-4 mm"}]},
 "analysis": {"velocity_carry_over": 0, "plane_strain": true, "step_count": 6, "time_step": "1 s",
  "allowed_displacement_ratio": 0.1, "gravity": "9.81 m/s2",
  "block_materials": [{"density": "2600 kg/m3", "unit_weight": "25 kN/m3", "youngs_modulus": "1 GPa",
    "poissons_ratio": 0.25, "strength": {"surface": "mohr_coulomb", "cohesion": "500 kPa", "friction_deg": "0.5 rad",
      "dilation_deg": "5 deg"}}],
  "joint_materials": [{}]})";

/// Numbers of one output: by their place, each with its value in SI or marked as plain.
struct Number {
  double value = 0;
  std::string kind;  ///< the dimension, so that small differences are compared with the largest number of it
  bool is_short = false;
};
using Numbers = std::map<std::string, Number>;

std::string kind_of(const std::string& unit) {
  if (unit.empty()) return "number";
  const std::optional<Unit> found = unit_named(unit);
  EXPECT_TRUE(found) << "no unit: " << unit;
  if (!found) return "none";
  if (found->is_angle) return unit;
  return fmt::format("{} {} {}", found->dimension.mass, found->dimension.length, found->dimension.time);
}

double factor_of(const std::string& unit) {
  if (unit.empty()) return 1;
  const std::optional<Unit> found = unit_named(unit);
  return found && !found->is_angle ? found->factor : 1;
}

/// "gap [mm]" as its name, with # for a number in it, and its unit.
std::pair<std::string, std::string> name_and_unit(const std::string& heading) {
  const std::size_t open = heading.find(" [");
  std::string name = heading.substr(0, open);
  const std::string unit = open == std::string::npos ? "" : heading.substr(open + 2, heading.size() - open - 3);
  // K_I2 is one word; x12 is x#.
  if (const std::size_t at = name.find_first_of("0123456789"); at != std::string::npos) {
    const std::size_t end = std::min(name.find_first_not_of("0123456789", at), name.size());
    name = name.substr(0, at) + "#" + name.substr(end);
  }
  return {name, unit};
}

/// The dimension in the heading must be that of the table above.
void expect_kind(const std::string& heading, const std::string& where) {
  auto [name, unit] = name_and_unit(heading);
  // Ends of a bolt.
  if (where.ends_with("bolts.csv") && (name == "x#" || name == "y#")) name = name.substr(0, 1);
  if (kNumbers.contains(name)) {
    EXPECT_EQ(unit, "") << where << ": " << heading;
    return;
  }
  const auto kind = kKinds.find(name);
  ASSERT_NE(kind, kKinds.end()) << where << " has a column that no table of dimensions knows: " << heading;
  EXPECT_EQ(kind_of(unit), kind_of(kind->second)) << where << ": " << heading;
}

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Numbers numbers_of_table(const fs::path& file) {
  Numbers found;
  const formats::CsvTable table = formats::read_csv(formats::load(file.string()));
  for (const std::string& heading : table.header) expect_kind(heading, file.filename().string());
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    for (std::size_t column = 0; column < table.header.size(); ++column) {
      auto [name, unit] = name_and_unit(table.header[column]);
      // In long form each row names the unit of its value, 1 for a plain number.
      if (name == "value") unit = table.rows[row].cells.back() == "1" ? "" : table.rows[row].cells.back();
      const std::string bare = table.header[column].substr(0, table.header[column].find(" ["));
      if (const auto value = number_in(table.rows[row].cells[column]))
        found[fmt::format("row {}, {}", row, bare)] = {*value * factor_of(unit), kind_of(unit)};
    }
  return found;
}

void put_array(Numbers& found, const pugi::xml_node& array, const std::string& where, const System& system) {
  const std::string heading = array.attribute("Name").value();
  const std::string type = array.attribute("type").value();
  const bool is_place = heading == "Points";
  if (!is_place && (heading == "connectivity" || heading == "offsets" || heading == "types")) return;
  if (!is_place && heading != "TimeValue") expect_kind(heading, where);
  const auto [name, unit] = name_and_unit(heading);
  std::string text = array.text().get();
  std::size_t count = 0;
  for (std::size_t at = text.find_first_not_of(" \n"); at != std::string::npos;
       at = text.find_first_not_of(" \n", at)) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    const double factor = is_place ? 1 / system.metre : factor_of(unit);
    if (const auto value = number_in(text.substr(at, end - at)))
      found[fmt::format("{} {}, {}", array.parent().name(), name, count++)] = {
          *value * factor, is_place ? kind_of("m") : kind_of(unit), type == "Float32"};
    at = end;
  }
}

Numbers numbers_of_frame(const fs::path& file, const System& system) {
  Numbers found;
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(support::read_text(file).c_str())) << file;
  for (const pugi::xpath_node& node : document.select_nodes("//DataArray"))
    put_array(found, node.node(), file.filename().string(), system);
  return found;
}

void put_json(Numbers& found, const Json& value, const std::string& path, const std::string& kind, const Json& units) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items())
      put_json(found, inner, path.empty() ? key : path + "." + key, kind.empty() ? key : kind + "." + key, units);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i)
      put_json(found, value[i], fmt::format("{}[{}]", path, i), kind + "[]", units);
  } else if (value.is_number()) {
    const std::string unit = units.contains(kind) ? units[kind].get<std::string>() : "";
    found[path] = {value.get<double>() * factor_of(unit), kind_of(unit)};
  }
}

Numbers numbers_of_record(const fs::path& file) {
  Json record = Json::parse(support::read_text(file));
  const Json units = record.at("unit_of");
  for (const char* key : {"seconds", "inputs", "unit_of", "units"}) record.erase(key);
  Numbers found;
  put_json(found, record, "", "", units);
  return found;
}

/// Numbers on axes and bars. Those of an axis come before its label. Each is taken with every unit that the picture
/// names, as a list of its possible values.
struct Picture {
  std::vector<std::string> units;
  std::vector<double> factors;  ///< of each
  std::vector<double> numbers;
  std::vector<double> bars;  ///< in SI
};

Picture picture_in(const fs::path& file) {
  Picture picture{{""}, {1}, {}, {}};
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(support::read_text(file).c_str())) << file;
  for (const pugi::xpath_node& node : document.select_nodes("//text")) {
    const std::string text = node.node().text().get();
    EXPECT_EQ(text.find("of the input"), std::string::npos) << file << ": " << text;
    if (const auto value = number_in(text)) picture.numbers.push_back(*value);
    // "energy [N·m/m]  × 1e3"
    const std::size_t open = text.find('['), close = text.find(']');
    if (open != std::string::npos && close != std::string::npos && text.substr(open, 4) != "[–") {
      picture.units.push_back(text.substr(open + 1, close - open - 1));
      const std::size_t power = text.find("× ");
      const double times = power == std::string::npos ? 1 : std::stod(text.substr(power + std::string("× ").size()));
      picture.factors.push_back(times * factor_of(picture.units.back()));
    }
    if (const auto quantity = quantity_in(text); quantity && unit_named(quantity->unit))
      picture.bars.push_back(quantity->number * factor_of(quantity->unit));
  }
  return picture;
}

using Scales = std::map<std::string, double>;  ///< the largest number of each kind in a run

void add_to(Scales& scales, const Numbers& numbers) {
  for (const auto& [place, number] : numbers) {
    double& most = scales[number.kind];
    most = std::max(most, std::abs(number.value));
  }
}

// Rounding decides the number of linear solves, and which of two equal elements is named.
bool is_left_to_rounding(const std::string& place) {
  return std::ranges::any_of(
      std::array<std::string_view, 7>{"unbalanced", "passes", "oci", ".element", "solves", "misfit", "residual"},
      [&](std::string_view word) { return place.find(word) != std::string::npos; });
}

void expect_same(const Numbers& one, const Numbers& other, const Scales& scales, const std::string& where) {
  EXPECT_EQ(one.size(), other.size()) << where;
  int wrong = 0;
  for (const auto& [place, number] : one) {
    const auto found = other.find(place);
    ASSERT_NE(found, other.end()) << where << " lacks " << place;
    EXPECT_EQ(found->second.kind, number.kind) << where << ", " << place;
    if (is_left_to_rounding(place)) continue;
    const double difference = std::abs(found->second.value - number.value);
    const double allowed =
        kRelative * scales.at(number.kind) + (number.is_short ? kRelativeOfShort * std::abs(number.value) : 0);
    if (difference <= allowed) continue;
    EXPECT_LE(difference, allowed) << where << ", " << place << ": " << number.value << " and " << found->second.value;
    if (++wrong > 3) return;  // enough to see which
  }
}

// Ticks are round in each system: the same ones if the units differ by a power of ten.
void expect_same_picture(const Picture& one, const Picture& other, const std::string& where) {
  ASSERT_EQ(one.units.size(), other.units.size()) << where;
  for (std::size_t i = 0; i < one.units.size(); ++i) {
    EXPECT_EQ(kind_of(one.units[i]), kind_of(other.units[i])) << where;
    const double power = std::log10(factor_of(one.units[i]) / factor_of(other.units[i]));
    if (std::abs(power - std::round(power)) > 1e-6) return;  // N/mm^1.5: its ticks are at other places
  }
  ASSERT_EQ(one.numbers.size(), other.numbers.size()) << where;
  ASSERT_EQ(one.bars.size(), other.bars.size()) << where;
  for (std::size_t i = 0; i < one.bars.size(); ++i)
    EXPECT_NEAR(other.bars[i], one.bars[i], 1e-5 * std::abs(one.bars[i])) << where;
  for (std::size_t i = 0; i < one.numbers.size(); ++i) {
    bool is_same = false;
    for (std::size_t u = 0; u < one.units.size(); ++u) {
      const double a = one.numbers[i] * one.factors[u], b = other.numbers[i] * other.factors[u];
      is_same = is_same || std::abs(a - b) <= 1e-5 * std::abs(a);
    }
    EXPECT_TRUE(is_same) << where << ": " << one.numbers[i] << " and " << other.numbers[i];
  }
}

std::string run_in(const System& system, const std::string& name, const std::string& scene) {
  const std::string folder = support::fresh_folder(fmt::format("units_{}_{}", name, system.name));
  support::write_text(folder + "/case.json",
                      "{\"keyblock\": 1, \"units\": " + std::string(system.units) + "," + scene + "}\n");
  const support::ProgramRun run =
      support::run_keyblock({"run", folder + "/case.json", "--trace", "--frames", "text", "-o", folder + "/out"});
  EXPECT_LE(run.exit_code, 1) << run.messages;
  return folder + "/out";
}

std::set<std::string> files_in(const std::string& folder) {
  std::set<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder).string());
  return files;
}

std::map<std::string, Numbers> numbers_in(const std::string& folder, const std::set<std::string>& files,
                                          const System& system) {
  std::map<std::string, Numbers> all;
  for (const std::string& file : files) {
    const fs::path path = fs::path(folder) / file;
    if (file.ends_with(".csv")) all[file] = numbers_of_table(path);
    if (file.ends_with(".vtu") || file.ends_with(".vtp")) all[file] = numbers_of_frame(path, system);
    if (file == "run.json") all[file] = numbers_of_record(path);
  }
  return all;
}

// `scales`: of sums that vanish in the run, as those of balanced loads do.
void expect_same_results(const std::string& name, const std::string& scene, const std::set<std::string>& wanted,
                         Scales scales) {
  scales.merge(Scales{{"number", 1}, {"rad", 1}, {"deg", 180}});
  const std::string first = run_in(kSystems[0], name, scene);
  const std::set<std::string> files = files_in(first);
  for (const std::string& file : wanted) EXPECT_TRUE(files.contains(file)) << file;
  const auto reference = numbers_in(first, files, kSystems[0]);
  for (const auto& [file, numbers] : reference) add_to(scales, numbers);
  for (std::size_t s = 1; s < kSystems.size(); ++s) {
    const std::string folder = run_in(kSystems[s], name, scene);
    EXPECT_EQ(files_in(folder), files) << kSystems[s].name;
    for (const auto& [file, numbers] : numbers_in(folder, files, kSystems[s]))
      expect_same(reference.at(file), numbers, scales, fmt::format("{}, {}", kSystems[s].name, file));
    for (const std::string& file : files)
      if (file.ends_with(".svg"))
        expect_same_picture(picture_in(fs::path(first) / file), picture_in(fs::path(folder) / file),
                            fmt::format("{}, {}", kSystems[s].name, file));
  }
}

}  // namespace

TEST(UnitsInOutputs, of_blocks_in_motion) {
  expect_same_results("blocks", kSliding,
                      {"history.csv", "points.csv", "contacts.csv", "joints.csv", "bolts.csv", "step_table.csv",
                       "ledger.csv", "steps.csv", "blocks.csv", "run.json", "picture.svg", "energy.svg", "field.svg"},
                      {});
}

TEST(UnitsInOutputs, of_a_crack_that_grows) {
  expect_same_results("crack", kCrack,
                      {"tips.csv", "cracks.svg", "history.csv", "histories.csv", "step_table.csv", "run.json"},
                      {{kind_of("N/m"), 1e6}, {kind_of("N·m/m"), 1e6}});
}

TEST(UnitsInOutputs, of_rock_that_yields) {
  expect_same_results("pillar", kPillar,
                      {"history.csv", "points.csv", "rounds.csv", "reactions.svg", "plastic.svg", "run.json"}, {});
}

}  // namespace keyblock::units_in_outputs_test
