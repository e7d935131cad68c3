// The case file: its contents get their place, and forbidden contents are named at theirs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/keyblock_case.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "formats/case_file/case_meanings.hpp"
#include "settings/settings_table.hpp"
#include "tests/formats/reading.hpp"

namespace keyblock::formats::keyblock_case_test {
namespace {

const std::string kSquare = R"({
 "keyblock": 1, // the version
 "units": {"length": "m", "mass": "kg", "time": "s"},
 "blocks": {
  "blocks": [{"material": 1, "outer": [[0, 0, 1], [1, 0, 2], [1, 1, 1]]}],
  "fixed_points": [[0.25, 0.125, 1]]
 },
 "analysis": {
  "step_count": 10, "time_step": 0.01, "allowed_displacement_ratio": 0.1,
  "block_materials": [{"density": 2500, "youngs_modulus": 5e9, "initial_stress": [1, 2, 3]}],
  "joint_materials": [{"friction_angle_deg": 30}]
 },
 "run": {"profile": "standard", "set": {"motion": "static"}}
})";

std::string with(const std::string& old_text, const std::string& new_text) {
  std::string text = kSquare;
  return text.replace(text.find(old_text), old_text.size(), new_text);
}

}  // namespace

TEST(KeyblockCase, what_it_holds_lands_in_its_place) {
  const Reading reading = read({"f", kSquare});
  const Content& content = reading.content;
  EXPECT_EQ(content.units, (Units{"m", "kg", "s"}));
  const BlockPolygon& block = content.blocks->blocks.at(0);
  EXPECT_EQ(block.material, 0);
  EXPECT_EQ(block.outer.at(1), (BlockVertex{{1, 0}, 1}));
  EXPECT_EQ(content.blocks->fixed_points.at(0).position, (Point{0.25, 0.125}));
  EXPECT_EQ(content.blocks->fixed_points.at(0).place, (Place{"f", 6, 20}));
  EXPECT_EQ(content.analysis->step_count, 10);
  EXPECT_EQ(content.analysis->block_materials.at(0).initial_stress, (Stress{1, 2, 3}));
  EXPECT_EQ(content.analysis->penalty_factor, Analysis{}.penalty_factor);
  EXPECT_EQ(content.choices, (RunChoices{"standard", {{"motion", "static"}}}));
}

TEST(KeyblockCase, faults_are_named_where_they_stand) {
  EXPECT_EQ(error_of(with("\"keyblock\": 1", "\"keyblock\": 3")),
            "f:2:14: error: expected keyblock of the case file: version 1 or 2, found 3");
  EXPECT_EQ(error_of(with("friction_angle_deg", "phi")),
            "f:11:24: error: expected a key of joint_materials: name, like, friction_angle_deg, cohesion, "
            "tensile_strength, found "
            "\"phi\"");
  EXPECT_EQ(error_of(with("30", "\"30\"")),
            "f:11:46: error: expected friction_angle_deg: a number, or an angle, such as \"30 deg\", found \"30\"");
  EXPECT_EQ(
      error_of(with("[1, 0, 2]", "[1, 0]")),
      "f:5:51: error: expected joint_material of outer as value 3 of the row (x, y, joint_material), found a row of 2");
  EXPECT_EQ(error_of(with("[1, 0, 2]", "[1, 0, 2, 3]")),
            "f:5:61: error: expected the end of outer: x, y, joint_material, found 3");
  EXPECT_EQ(error_of(with("0.125, 1]", "0.125, 2]")), "f:6:20: error: expected the number of a block, 1 to 1, found 2");
  EXPECT_EQ(error_of(with("\"step_count\": 10, ", "")),
            "f:8:14: error: expected the key step_count of analysis: a whole number from 1 to 100000000, found none");
  EXPECT_EQ(error_of(with("\"step_count\"", "\"step_cuont\"")).substr(0, 74),
            "f:9:3: error: expected a key of analysis (did you mean \"step_count\"?): dia");
  EXPECT_EQ(error_of(with("\"length\": \"m\"", "\"length\": \"furlong\"")).substr(0, 60),
            "f:3:11: error: expected length of units: one of m, mm, cm, d");
  EXPECT_EQ(error_of(with("\"run\"", "\"units\"")),
            "f:13:2: error: expected each key of the case file once, found \"units\"");
}

namespace {

std::string on_covers(const std::string& section) {
  return "{\"keyblock\": 1,\n\"covers\": " + section + "}";
}

constexpr const char* kMesh = R"("mesh": {"side": 0.5})";

}  // namespace

TEST(KeyblockCase, covers_hold_mesh_supports_and_loads) {
  const Reading reading = read({"f", on_covers(R"json({"functions": "linear",
 "mesh": {"kind": "unstructured", "side": 2, "refined": [[1, 2, 0.1]], "placement": "aligned"},
 "tractions": [{"along": [[0, 0], [1, 0]], "x": "3*y", "pressure": 7}],
 "displacements": [{"along": [[0, 0], [0, 1]], "held": "normal"}, {"along": [[1, 1], [2, 1]], "x": 0.25}],
 "forces": [[1, 2, 3, 4]], "springs": [[1, 2, 0, 1, 1000]],
 "body_force": {"y": "-9.81 * 2500"}, "initial_stress_field": {"yy": "25*(y - 10)"},
 "excavations": [{"step": 2, "outline": [[0, 0], [1, 0], [1, 1]]}]})json")});
  const CoverPlan& plan = *reading.content.covers;
  EXPECT_EQ(plan.functions, CoverFunctions::linear);
  EXPECT_EQ(plan.mesh.kind, MeshKind::unstructured);
  EXPECT_EQ(plan.mesh.refined.at(0).side, 0.1);
  EXPECT_EQ(plan.tractions.at(0).x.text, "3*y");
  EXPECT_EQ(plan.tractions.at(0).pressure.text, "7");
  EXPECT_EQ(plan.displacements.at(0).held, Held::normal);
  EXPECT_EQ(plan.displacements.at(1).held, Held::both);
  EXPECT_EQ(plan.forces.at(0).force, (Point{3, 4}));
  EXPECT_EQ(plan.springs.at(0).stiffness, 1000);
  EXPECT_EQ(plan.initial_stress.yy.text, "25*(y - 10)");
  EXPECT_EQ(plan.initial_stress.xy.text, "0");
  EXPECT_EQ(plan.excavations.at(0).outline.at(2), (Point{1, 1}));
}

TEST(KeyblockCase, faults_of_covers_are_named_where_they_stand) {
  const auto fault = [](const std::string& more) {
    return error_of(on_covers(fmt::format("{{{}, {}}}", kMesh, more)));
  };
  EXPECT_EQ(error_of(on_covers(R"({"mesh": {"side": 1, "half_rows": 3}})")),
            "f:2:20: error: expected a mesh with one of half_rows and side, found both");
  EXPECT_EQ(error_of(on_covers("{}")),
            "f:2:11: error: expected a mesh with one of half_rows and side, found none above 0");
  const auto fault_of_mesh = [](const std::string& mesh) {
    return error_of(on_covers(fmt::format(R"({{"mesh": {{"side": 1, {}}}}})", mesh))).substr(15);
  };
  EXPECT_EQ(fault_of_mesh(R"("kind": "unstructured", "angle": 7)"),
            "expected no angle of an unstructured mesh, found 7");
  EXPECT_EQ(fault_of_mesh(R"("angle": 700)"), "expected an angle from -180 to 180, found 700");
  EXPECT_EQ(fault_of_mesh(R"("snap_ratio": 0.5)"), "expected a snap_ratio of at most 0.1, found 0.5");
  EXPECT_EQ(fault(R"("body_force": {"y": "2*z"})"),
            "f:2:58: error: expected a number or an expression in x, y, found \"z\"");
  EXPECT_EQ(fault(R"("body_force": {"y": "2*(x"})").substr(0, 61),
            "f:2:60: error: expected a number or an expression in x, y, fo");
  EXPECT_EQ(fault(R"("tractions": [{"along": [[0, 0], [1, 0]], "x": "x = 3"}])"),
            "f:2:85: error: expected a number or an expression in x, y, nx, ny, found an assignment");
  EXPECT_EQ(fault(R"("tractions": [{"along": [[0, 0], [1, 0]], "x": "1, 2"}])"),
            "f:2:83: error: expected a number or an expression in x, y, nx, ny, found 2 values in \"1, 2\"");
  EXPECT_EQ(fault(R"("tractions": [{"along": [[0, 0]], "x": 1}])"),
            "f:2:49: error: expected 2 points at least along a boundary, found 1");
  EXPECT_EQ(fault(R"("displacements": [{"along": [[0, 0], [1, 0]], "held": "normal", "y": 1}])"),
            "f:2:104: error: expected no y if held is x or normal, found 1");
  EXPECT_EQ(fault(R"("displacements": [{"along": [[0, 0], [1, 0]], "held": "none"}])"),
            "f:2:89: error: expected held of displacements: one of both, normal, x, y, found \"none\"");
  EXPECT_EQ(fault(R"("springs": [[0, 0, 0, 0, 5]])"),
            "f:2:47: error: expected a direction of the spring, found (0, 0)");
  EXPECT_EQ(fault(R"("excavations": [{"step": 0, "outline": []}])").substr(0, 62),
            "f:2:60: error: expected step of excavations: a whole number fr");
}

TEST(KeyblockCase, results_are_held_and_their_faults_named) {
  const std::string element = "[1, [[[0, 0], [3, 0], [0, 3]]], 1, 1, 0.5, 0, 0, 0, 0, 0, 0, 0, 0, 4.5, 0, 0]";
  const auto text = [&](const std::string& elements, const std::string& tracks) {
    return "{\"keyblock\": 1,\n\"frames\": [{\"time\": 2, \"elements\": [\n" + elements + "]}],\n\"tracks\": [\n" +
           tracks + "]}";
  };
  const std::string track = R"({"point": 2, "rows": [[1, 0.5, 0.5, 2, 3, 0.1, 1, -1, 1.5]]})";
  const Content content = read({"f", text(element, track)}).content;
  EXPECT_EQ(content.frames.at(0).time, 2);
  EXPECT_EQ(content.frames[0].elements.at(0).displacement, (Point{0.5, 0}));
  EXPECT_EQ(content.frames[0].elements[0].area, 4.5);
  EXPECT_EQ(content.tracks.at(0), (MeasuredTrack{1, {{1, 0.5, 0.5, {2, 3}, 0.1, {1, -1}, 1.5}}}));
  EXPECT_EQ(error_of(text(element + ",\n[1, [[[0, 0], [3, 0]]], 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]", track)),
            "f:4:1: error: expected 3 corners at least in each loop of an element, found 2");
  EXPECT_EQ(error_of(text("[1, []]", track)).substr(0, 60),
            "f:3:5: error: expected loops of elements: 1 or more, found a");
  EXPECT_EQ(error_of(text("", track)), "f:2:36: error: expected elements of frames: 1 or more, found an array");
  EXPECT_EQ(error_of(text(element, R"({"point": 2})")),
            "f:5:1: error: expected the key rows of tracks: an array, found none");
  EXPECT_EQ(error_of(text(element, R"({"point": 2, "rows": [[1.5, 0, 0, 0, 0, 0, 0, 0, 0]]})")),
            "f:5:24: error: expected step of rows: a whole number, found 1.5");
}

TEST(KeyblockCase, the_schema_knows_the_keys_of_the_file) {
  const auto schema = nlohmann::json::parse(case_schema());
  const auto file = nlohmann::json::parse(kSquare, nullptr, true, true);
  for (const auto& [key, value] : file.items()) EXPECT_TRUE(schema["properties"].contains(key)) << key;
  const auto& analysis = schema["properties"]["analysis"]["properties"];
  for (const auto& [key, value] : file["analysis"].items()) EXPECT_TRUE(analysis.contains(key)) << key;
  EXPECT_EQ(schema["properties"]["blocks"]["properties"]["fixed_points"]["items"]["prefixItems"].size(), 3U);
}

namespace {

using Json = nlohmann::ordered_json;

// Every key and every place of a row below `schema`, as "path: description".
void list_descriptions(const Json& schema, const std::string& path, std::map<std::string, std::string>& all) {
  if (schema.is_object() && schema.contains("properties"))
    for (const auto& [key, value] : schema["properties"].items()) {
      all[path + "." + key] = value.value("description", "");
      list_descriptions(value, path + "." + key, all);
    }
  if (schema.is_object() && schema.contains("prefixItems"))
    for (const Json& place : schema["prefixItems"])
      all[path + "[]." + place["x-key"].get<std::string>()] = place.value("description", "");
  if (schema.is_object() && schema.contains("items")) list_descriptions(schema["items"], path, all);
}

}  // namespace

TEST(KeyblockCase, the_schema_says_what_every_key_means) {
  std::map<std::string, std::string> all;
  list_descriptions(Json::parse(case_schema()), "", all);
  EXPECT_GT(all.size(), 100U);
  for (const auto& [path, description] : all) EXPECT_NE(description, "") << path;
  EXPECT_EQ(all.at(".analysis.point_loads[].x"), "x component, F");
  EXPECT_EQ(all.at(".analysis.block_materials.density"), "mass per volume, M/L³. Permitted: greater than 0");
}

namespace {

// Settings may also be texts and words; their limits tell numbers.
bool needs_unit(const Json& schema) {
  const std::string types = schema.value("type", Json()).dump();
  const bool is_setting = types.find("boolean") != std::string::npos;
  if (is_setting) return schema.value("x-permitted", "").find("number") != std::string::npos;
  return types.find("number") != std::string::npos || types.find("integer") != std::string::npos;
}

// Faults of the words on each key, place of a row and setting below `schema`; counts them.
void list_faults(const Json& schema, const std::string& path, std::vector<std::string>& faults, int& count) {
  const auto check = [&](const std::string& own, const Json& value) {
    ++count;
    for (const char* needed : {"title", "description"})
      if (value.value(needed, "").empty()) faults.push_back(own + " lacks " + needed);
    if (needs_unit(value) && value.value("x-unit", "").empty()) faults.push_back(own + " lacks x-unit");
    if (value.contains("x-permitted") &&
        !value["description"].get<std::string>().ends_with(". Permitted: " + value["x-permitted"].get<std::string>()))
      faults.push_back(own + " has other limits in its description");
    list_faults(value, own, faults, count);
  };
  const Json keys = schema.value("properties", Json::object());
  for (const auto& [key, value] : keys.items()) check(path + "." + key, value);
  for (const Json& place : schema.value("prefixItems", Json::array()))
    check(path + "[]." + place["x-key"].get<std::string>(), place);
  if (schema.contains("items") && schema["items"].is_object()) list_faults(schema["items"], path, faults, count);
}

}  // namespace

TEST(KeyblockCase, every_key_and_setting_has_a_title_a_meaning_and_a_unit_or_none) {
  std::vector<std::string> faults;
  int count = 0;
  const Json schema = Json::parse(case_schema());
  list_faults(schema, "", faults, count);
  EXPECT_EQ(faults, std::vector<std::string>{});
  EXPECT_GT(count, 400);
  const Json& analysis = schema["properties"]["analysis"]["properties"];
  const Json& rock = analysis["block_materials"]["items"]["properties"];
  EXPECT_EQ(rock["youngs_modulus"]["title"], "Young's modulus");
  EXPECT_EQ(rock["youngs_modulus"]["x-unit"], "F/L²");
  EXPECT_EQ(rock["poissons_ratio"]["x-unit"], "none");
  EXPECT_EQ(analysis["dialect"]["x-group"], "Old files");
  EXPECT_EQ(analysis["dialect"]["x-words"]["shi"], "Shi's DDA");
  const Json& settings = schema["properties"]["run"]["properties"]["set"]["properties"];
  EXPECT_EQ(settings.size(), list(Settings{}).size());
  EXPECT_EQ(settings["time_step"]["x-unit"], "T");
  for (const Json& section : schema["x-sections"]) {
    const Json* own = &schema;
    for (const std::string key : section["path"]) own = &(*own)["properties"][key];
    EXPECT_FALSE(own->is_null()) << section;
  }
}

TEST(KeyblockCase, the_schema_has_the_limits_of_the_reader) {
  const Json schema = Json::parse(case_schema());
  const Json& analysis = schema["properties"]["analysis"]["properties"];
  EXPECT_EQ(analysis["time_step"]["exclusiveMinimum"], 0);
  EXPECT_EQ(analysis["step_count"]["minimum"], 1);
  EXPECT_EQ(analysis["step_count"]["maximum"], 100000000);
  const Json& rock = analysis["block_materials"]["items"]["properties"];
  EXPECT_EQ(rock["poissons_ratio"]["minimum"], 0);
  EXPECT_EQ(rock["poissons_ratio"]["maximum"], 0.5);
  EXPECT_EQ(rock["strength"]["properties"]["friction_deg"]["exclusiveMaximum"], 90);
  const Json& settings = schema["properties"]["run"]["properties"]["set"]["properties"];
  EXPECT_EQ(settings["force_tolerance"]["exclusiveMinimum"], 0);
  EXPECT_EQ(settings["force_tolerance"]["maximum"], 0.001);
  EXPECT_EQ(settings["plane"]["enum"], Json({"stress", "strain"}));
}

TEST(KeyblockCase, every_meaning_belongs_to_a_key) {
  std::map<std::string, std::string> all;
  list_descriptions(Json::parse(case_schema()), "", all);
  for (const CaseMeaning& row : case_meanings()) {
    const auto says_it = [&](const auto& entry) { return entry.second.starts_with(row.meaning); };
    EXPECT_TRUE(std::ranges::any_of(all, says_it)) << row.key;
  }
}

TEST(KeyblockCase, the_schema_names_defaults_needed_keys_and_units) {
  const Json schema = Json::parse(case_schema());
  const Json& keys = schema["properties"];
  const Json& analysis = keys["analysis"]["properties"];
  EXPECT_EQ(keys["analysis"]["required"], Json({"step_count", "time_step"}));
  EXPECT_EQ(schema["if"]["properties"]["keyblock"]["const"], 1);
  EXPECT_EQ(schema["then"]["properties"]["analysis"]["required"], Json({"allowed_displacement_ratio"}));
  EXPECT_EQ(analysis["penalty_factor"]["default"], Analysis{}.penalty_factor);
  EXPECT_EQ(analysis["dialect"]["default"], "berkeley");
  EXPECT_EQ(analysis["plane_strain"]["default"], false);
  EXPECT_EQ(analysis["block_materials"]["items"]["anyOf"][1]["required"], Json({"density", "youngs_modulus"}));
  EXPECT_EQ(keys["blocks"]["properties"]["blocks"]["items"]["properties"]["material"]["default"], 1);
  for (const std::string unit : keys["units"]["properties"]["length"]["enum"])
    EXPECT_EQ(error_of(with("\"length\": \"m\"", "\"length\": \"" + unit + "\"")), "") << unit;
  EXPECT_EQ(keys["drawing"]["properties"]["edge_node_ratio"]["default"], 0.001);
}

TEST(KeyblockCase, a_weight_or_edge_node_ratio_that_is_absent_is_said) {
  EXPECT_EQ(names(read({"f", kSquare}).warnings), (std::vector<std::string>{"default_unit_weight"}));
  EXPECT_EQ(read({"f", kSquare}).warnings.at(0).place, (Place{"f", 10, 23}));
  EXPECT_EQ(names(read({"f", with("\"density\"", "\"unit_weight\": 0, \"density\"")}).warnings),
            std::vector<std::string>{});
  EXPECT_EQ(names(read({"f", with("\"step_count\"", "\"gravity\": 9.81, \"step_count\"")}).warnings),
            std::vector<std::string>{});
  const Reading drawing = read({"f", R"({"keyblock": 1, "drawing": {"joints": [[0, 0, 1, 0, 1]]}})"});
  EXPECT_EQ(drawing.content.drawing->edge_node_ratio, 0.001);  // as a DXF file without one
  EXPECT_EQ(names(drawing.warnings), (std::vector<std::string>{"default_edge_node_ratio"}));
}

}  // namespace keyblock::formats::keyblock_case_test
