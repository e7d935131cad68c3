// Every number of a case file that has a dimension may be written with its unit, and the schema says so.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/case_measures.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "formats/case_file/keyblock_case.hpp"
#include "tests/formats/reading.hpp"
#include "tests/support/content_text.hpp"

namespace keyblock::formats::case_measures_test {
namespace {

using Json = nlohmann::ordered_json;

const Units kMetres{"m", "kg", "s"};

// Hardly any field of a case file is missing here; the geometry is one of three.
const std::string kCommon = R"("analysis": {"step_count": 10, "time_step": 0.25, "allowed_displacement_ratio": 0.01,
  "contact_penalty": 5e8, "gravity": 9.5, "open_close": {"angle_overlap_deg": 3},
  "block_materials": [{"density": 2500, "unit_weight": 24500, "youngs_modulus": 2e10, "poissons_ratio": 0.25,
    "horizontal_force": 12, "initial_stress": [-1000, -2000, 300], "stress_gradient": [10, 20, 30],
    "initial_velocity": [0.5, -0.25, 0.125], "initial_strain": [0, 0, 0], "initial_stress_zz": -500,
    "stress_gradient_zz": 5,
    "strength": {"surface": "mohr_coulomb", "cohesion": 5e5, "friction_deg": 30, "dilation_deg": 10,
      "yield_stress": 1e6, "tensile_strength": 2e5, "after": {"cohesion": 1e5, "fracture_energy": 80}},
    "crack_closure": {"initial_modulus": 1e10, "closure_strain": 0.001},
    "toughness": {"mode_1": 1.5e6, "mode_2": 2e6, "tensile_strength": 1e6}}],
  "joint_materials": [{"friction_angle_deg": 30, "cohesion": 1000, "tensile_strength": 500}],
  "bolt_properties": [{"stiffness": 1e7, "strength": 2e5, "pretension": 1e4}],
  "fixed_point_motions": [[[0, 0, 0], [1, 0.5, 0.25]]], "point_loads": [[[0, 100, -200], [2, 50, 0]]],
  "body_acceleration": [[0, 0, 0], [1, 0.5, 0.25]]},
 "motion": [[0, 0.1, 0.2], [1, 0, 0]],
 "run": {"set": {"time_step": "0.5", "contact_penalty": "1000", "mass_damping": "2", "gravity": "9"}})";
const std::string kDrawing = R"("drawing": {"edge_node_ratio": 0.001, "joints": [[0, 0, 4, 0, 1]],
  "material_lines": [[0, 1, 2, 1, 1]], "bolts": [[1, 1, 2, 2, 1e7, 1e5, 1e4, 1]], "fixed_lines": [[0, 0, 1, 0]],
  "loading_points": [[1, 2]], "measured_points": [[2, 3]], "hole_points": [[3, 1]]},
 "stages": [{"duration": 0.5, "equilibrium": 0.001, "excavations": [{"outline": [[0, 0], [1, 0], [1, 1]]}],
  "cuts": [[0, 0, 1, 1, 1]], "block_materials": [{"outline": [[0, 0], [1, 0], [1, 1]], "block_material": 1}],
  "bolts": [[1, 1, 2, 2, 1e7, 1e5, 1e4, 1]], "removed_bolts": [[1]], "held_points": [[0.5, 0.5]],
  "released": [{"outline": [[0, 0], [1, 0], [1, 1]]}],
  "forces": [[0.5, 0.5, 100, -50]], "set": {"time_step": "0.125"}}])";
const std::string kBlocks = R"("blocks": {"blocks": [{"material": 1, "outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1]],
   "holes": [[[0.5, 0.25, 1], [0.5, 0.5, 1], [0.75, 0.5, 1]]]}],
  "bolts": [[0, 0, 1, 1, 1, 1, 1e7, 1e5, 1e4]], "fixed_points": [[0, 0, 1]], "loading_points": [[1, 0, 1]],
  "measured_points": [[1, 1, 1]]},
 "covers": {"mesh": {"side": 0.25, "angle": 10, "through_x": 0.5, "through_y": 0.25, "refined": [[1, 1, 0.125]],
   "tip_side": 0.0625}, "tractions": [{"along": [[0, 0], [1, 0]], "x": 100, "y": "1/16", "pressure": 50}],
  "displacements": [{"along": [[0, 0], [0, 1]], "held": "both", "x": 0.5, "y": 0.25},
                    {"along": [[0, 0], [0, 1]], "held": "normal", "normal": 0.125}],
  "forces": [[1, 1, 100, -200]], "springs": [[0, 1, 1, 0, 1e6]], "body_force": {"x": 10, "y": -20},
  "initial_stress_field": {"xx": -100, "yy": -200, "xy": 30, "zz": -40},
  "excavations": [{"step": 2, "outline": [[0, 0], [1, 0], [1, 1]]}],
  "cracks": [{"along": [[0, 0.5], [0.5, 0.5]], "joint_material": 1}], "growth": {"increment": 0.03125}},
 "frames": [{"step": 1, "time": 0.5, "elements": [[1, [[[0, 0], [1, 0], [1, 1]]], 0.5, 0.25, 0.125, 0.25, 0.5, 1, 2,
    3, -100, -200, 50, 0.5, 1250, 100]], "bolts": [[0, 0, 1, 1, 5000, false]],
   "fixed_points": [[0, 0, 0.125, 0.25, 1]]}],
 "tracks": [{"point": 1, "rows": [[1, 0.5, 0.25, 1, 1, 0.125, 0.5, 0.25, 0.75]]}])";
const std::string kCover = R"("cover": {"elements": [[1, 3, 1, 1, 2, 3]], "vertices": [[0, 0], [1, 0], [0, 1], [0, 0]],
  "nodes": [[0, 0], [1, 0], [0, 1]], "loops": [[1, 3]], "loop_vertices": [[1, 1], [2, 1], [3, 1], [1, 1]],
  "fixed_points": [[0.25, 0.25, 1]]})";

std::string case_of(const std::string& geometry,
                    const std::string& units = R"({"length": "m", "mass": "kg", "time": "s"})") {
  return "{\"keyblock\": 1, \"units\": " + units + ",\n " + geometry + ",\n " + kCommon + "}\n";
}

bool takes_both(const Json& schema) {
  return schema.contains("type") && schema["type"].is_array() && schema["type"][0] == "number";
}

/// Returns the measure of each number of the schema, by its path; empty if the table has none.
void list_numbers(const Json& schema, const std::string& parent, const std::string& key, const std::string& path,
                  std::map<std::string, std::optional<Measure>>& found) {
  if (schema.contains("properties"))
    for (const auto& [name, inner] : schema["properties"].items())
      list_numbers(inner, key.empty() ? "case" : key, name, path + "." + name, found);
  if (schema.contains("prefixItems"))
    for (const Json& place : schema["prefixItems"]) {
      const std::string title = place["x-key"];
      list_numbers(place, key, title, path + "[" + title + "]", found);
    }
  if (schema.contains("items") && schema["items"].is_object()) list_numbers(schema["items"], parent, key, path, found);
  if (schema.value("type", Json()) == "number" || takes_both(schema)) found[path] = measure_of(parent, key);
}

/// Writes each number for which the schema permits a text with its unit.
void put_units(Json& value, const Json& schema, const std::string& parent, const std::string& key,
               std::set<std::string>& put) {
  if (value.is_object() && schema.contains("properties")) {
    for (auto& [name, inner] : value.items())
      put_units(inner, schema["properties"][name], key.empty() ? "case" : key, name, put);
    return;
  }
  if (value.is_array() && schema.contains("prefixItems")) {
    for (std::size_t i = 0; i < value.size(); ++i)
      put_units(value[i], schema["prefixItems"][i], key, schema["prefixItems"][i]["x-key"], put);
    return;
  }
  if (value.is_array() && schema.contains("items")) {
    for (Json& item : value) put_units(item, schema["items"], parent, key, put);
    return;
  }
  if (!value.is_number() || !takes_both(schema)) return;
  const std::string unit = unit_of(measure_of(parent, key).value_or(measures::kNumber), kMetres);
  if (unit.empty()) return;
  value = fmt::format("{} {}", value.get<double>(), unit);
  put.insert(parent + "." + key);
}

}  // namespace

TEST(CaseMeasures, every_number_of_the_schema_has_its_dimension) {
  std::map<std::string, std::optional<Measure>> found;
  list_numbers(Json::parse(case_schema()), "", "", "", found);
  EXPECT_GT(found.size(), 150U);
  for (const auto& [path, measure] : found) EXPECT_TRUE(measure) << path;
}

TEST(CaseMeasures, the_schema_takes_texts_where_the_reader_does) {
  std::set<std::string> put;
  for (const std::string& geometry : {kDrawing, kBlocks, kCover}) {
    const std::string plain = case_of(geometry);
    Json with_units = Json::parse(plain);
    put_units(with_units, Json::parse(case_schema()), "", "", put);
    // In SI the numbers stay what they are, to the last bit.
    EXPECT_EQ(support::content_text(read({"f", with_units.dump()}).content),
              support::content_text(read({"f", plain}).content));
  }
  EXPECT_GT(put.size(), 100U);
  for (const char* key : {"toughness.mode_1", "tractions.x", "displacements.normal", "body_force.y", "joints.x1",
                          "springs.stiffness", "point_loads.time", "point_loads.x", "body_acceleration.y",
                          "initial_velocity.rotation", "initial_stress.xx", "stress_gradient.xy", "forces.force_x"})
    EXPECT_TRUE(put.contains(key)) << key;
}

// By hand: 1 MPa√m = 10^1.5 N/mm^1.5 = 1000^0.5 N/mm^1.5, 100 kPa = 0.1 MPa, 1 kN/m³ = 1e-6 N/mm³, 20 MN/m/m = 20 MPa.
TEST(CaseMeasures, values_come_in_millimetres_and_tonnes) {
  const std::string units = R"({"length": "mm", "mass": "t", "time": "s"})";
  Json text = Json::parse(case_of(kBlocks, units));
  text["analysis"]["block_materials"][0]["toughness"]["mode_1"] = "1 MPa√m";
  text["analysis"]["block_materials"][0]["initial_velocity"] = {"2 m/s", "36 km/h", "90 deg/s"};
  text["analysis"]["block_materials"][0]["initial_stress"][0] = "-100 kPa";
  text["analysis"]["point_loads"][0][1] = {"500 ms", "2 kN/m", 0};
  text["covers"]["tractions"][0]["x"] = "100 kPa";
  text["covers"]["displacements"][0]["x"] = "2 cm";
  text["covers"]["body_force"]["y"] = "-1 kN/m3";
  text["covers"]["springs"][0][4] = "20 MN/m/m";
  text["blocks"]["blocks"][0]["outer"][1] = {"1.5 m", "20 cm", 1};
  text["run"]["set"]["time_step"] = "2 ms";
  text["run"]["set"]["gravity"] = "9.81 m/s2";
  const Content content = read({"f", text.dump()}).content;
  const BlockMaterial& rock = content.analysis->block_materials[0];
  EXPECT_NEAR(rock.toughness->mode_1, std::sqrt(1000.0), 1e-12);
  EXPECT_NEAR(rock.initial_velocity.x, 2000, 1e-9);
  EXPECT_NEAR(rock.initial_velocity.y, 10000, 1e-9);
  EXPECT_NEAR(rock.initial_velocity.rotation, std::acos(-1.0) / 2, 1e-15);
  EXPECT_NEAR(rock.initial_stress.xx, -0.1, 1e-16);
  EXPECT_EQ(content.analysis->point_loads[0].times[1], 0.5);
  EXPECT_NEAR(content.analysis->point_loads[0].values[1].x, 2, 1e-12);
  EXPECT_NEAR(std::stod(content.covers->tractions[0].x.text), 0.1, 1e-16);
  EXPECT_EQ(content.covers->tractions[0].y.text, "1/16");  // an expression stays one
  EXPECT_NEAR(std::stod(content.covers->displacements[0].x.text), 20, 1e-12);
  EXPECT_NEAR(std::stod(content.covers->body_force.y.text), -1e-6, 1e-20);
  EXPECT_NEAR(content.covers->springs[0].stiffness, 20, 1e-12);
  EXPECT_NEAR(content.blocks->blocks[0].outer[1].position.x, 1500, 1e-9);
  EXPECT_NEAR(content.blocks->blocks[0].outer[1].position.y, 200, 1e-9);
  const std::map<std::string, std::string> set(content.choices->settings.begin(), content.choices->settings.end());
  EXPECT_EQ(std::stod(set.at("time_step")), 0.002);
  EXPECT_NEAR(std::stod(set.at("gravity")), 9810, 1e-9);
  EXPECT_EQ(set.at("contact_penalty"), "1000");
}

TEST(CaseMeasures, strains_come_in_per_cent) {
  std::string text = case_of(kBlocks);
  const auto put = [&](const std::string& what, const std::string& by) {
    text.replace(text.find(what), what.size(), by);
  };
  put(R"("closure_strain": 0.001)", R"("closure_strain": "0.25 %")");
  put(R"("initial_strain": [0, 0, 0])", R"("initial_strain": ["5 ‰", "-1%", 0])");
  put(R"("fracture_energy": 80)", R"("plastic_strain": "2 %")");
  const Content content = read({"f", text}).content;
  const BlockMaterial& rock = content.analysis->block_materials[0];
  EXPECT_NEAR(rock.crack_closure->closure_strain, 0.0025, 1e-18);
  EXPECT_NEAR(rock.initial_strain[0], 0.005, 1e-18);
  EXPECT_NEAR(rock.initial_strain[1], -0.01, 1e-18);
  EXPECT_NEAR(rock.strength->change->plastic_strain, 0.02, 1e-17);
  put(R"("plastic_strain": "2 %")", R"("plastic_strain": "2 kN")");
  EXPECT_NE(error_of(text).find("plastic_strain of after"), std::string::npos);
  put(R"("plastic_strain": "2 kN")", R"("plastic_strain": 0.02)");
  put(R"("closure_strain": "0.25 %")", R"("closure_strain": 0.25)");
  EXPECT_EQ(std::ranges::count(names(read({"f", text}).warnings), "implausible_closure_strain"), 1);
}

TEST(CaseMeasures, a_value_of_another_kind_is_refused_at_its_place) {
  const auto error_with = [](const std::string& what, const std::string& by) {
    std::string text = case_of(kBlocks);
    text.replace(text.find(what), what.size(), by);
    return error_of(text);
  };
  EXPECT_NE(error_with("\"mode_1\": 1.5e6", "\"mode_1\": \"1.5 MPa\"")
                .find("expected mode_1: a number, or a stress intensity, such as \"1.5 MPa√m\", found \"1.5 MPa\""),
            std::string::npos);
  EXPECT_NE(error_with("\"pressure\": 50", "\"pressure\": \"50 kN/m\"")
                .find("expected pressure: a number, an expression, or a stress"),
            std::string::npos);
  EXPECT_NE(error_with("[[1, 1, 100, -200]]", "[[1, 1, \"100 kN\", -200]]")
                .find("expected force_x: a number, or a force per length of thickness, such as \"50 kN/m\""),
            std::string::npos);
  EXPECT_NE(error_with("\"poissons_ratio\": 0.25", "\"poissons_ratio\": \"0.25 m\"").find("poissons_ratio of"),
            std::string::npos);
  EXPECT_NE(error_with("\"contact_penalty\": \"1000\"", "\"contact_penalty\": \"5 GPa/s\"")
                .find("expected contact_penalty: a number, or a stiffness per length of thickness"),
            std::string::npos);
}

TEST(CaseMeasures, units_name_one_of_mass_force_and_stress) {
  const auto density_in = [](const std::string& units) {
    Json text = Json::parse(case_of(kBlocks, units));
    text["analysis"]["block_materials"][0]["density"] = "2500 kg/m3";
    return read({"f", text.dump()}).content.analysis->block_materials[0].density;
  };
  EXPECT_NEAR(density_in(R"({"length": "m", "force": "kN", "time": "s"})"), 2.5, 1e-15);
  EXPECT_NEAR(density_in(R"({"length": "m", "stress": "MPa", "time": "s"})"), 2.5e-3, 1e-18);
  EXPECT_NEAR(density_in(R"({"length": "mm", "stress": "MPa", "time": "s"})") / 2.5e-9, 1, 1e-14);
  EXPECT_NE(error_of(case_of(kBlocks, R"({"length": "m", "mass": "kg", "force": "kN"})"))
                .find("expected one of mass, force and stress in units: the others follow from it, found \"kN\""),
            std::string::npos);
}

}  // namespace keyblock::formats::case_measures_test
