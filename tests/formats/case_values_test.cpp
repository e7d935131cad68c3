// Values of a case file beside numbers: values with units, names of materials, a library, surplus commas.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/case_values.hpp"

#include <gtest/gtest.h>

#include "formats/case.hpp"
#include "formats/case_file/keyblock_case.hpp"
#include "formats/case_file/material_library.hpp"
#include "tests/formats/reading.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::formats::case_values_test {
namespace {

std::string case_of(const std::string& units, const std::string& rock, const std::string& joint,
                    const std::string& more = "", int version = 1) {
  return "{\"keyblock\": " + std::to_string(version) + ", \"units\": " + units +
         ",\n \"blocks\": {\"blocks\": [{\"material\": \"granite rock\", \"outer\": [[0, 0, \"bedding\"], [1, 0, 1], "
         "[1, 1, "
         "1]]}]},\n \"analysis\": {\"step_count\": 10, \"time_step\": \"2 ms\", " +
         more + "\n  \"block_materials\": [" + rock + "],\n  \"joint_materials\": [{}, " + joint + "]}}";
}

const std::string kMetre = R"({"length": "m", "mass": "kg", "time": "s"})";
const std::string kMillimetre = R"({"length": "mm", "mass": "t", "time": "s"})";
const std::string kRock =
    R"({"name": "granite rock", "density": "2600 kg/m3", "youngs_modulus": "20 GPa", "poissons_ratio": 0.2})";
const std::string kJoint = R"({"name": "bedding", "friction_angle_deg": "0.5 rad", "cohesion": "10 kPa"})";
const std::string kRatio = R"("allowed_displacement_ratio": 0.01,)";

}  // namespace

// 20 GPa is 20000 N/mm², and 2600 kg/m³ are 2.6e-9 t/mm³.
TEST(CaseValues, values_come_in_the_units_of_the_case) {
  const Analysis in_metres = *read({"f", case_of(kMetre, kRock, kJoint, kRatio)}).content.analysis;
  EXPECT_DOUBLE_EQ(in_metres.block_materials[0].youngs_modulus, 2e10);
  EXPECT_DOUBLE_EQ(in_metres.block_materials[0].density, 2600);
  EXPECT_DOUBLE_EQ(in_metres.joint_materials[1].cohesion, 1e4);
  EXPECT_NEAR(in_metres.joint_materials[1].friction_angle_deg, 28.64788975654116, 1e-12);
  EXPECT_DOUBLE_EQ(in_metres.time_step, 2e-3);
  const Analysis in_millimetres = *read({"f", case_of(kMillimetre, kRock, kJoint, kRatio)}).content.analysis;
  EXPECT_DOUBLE_EQ(in_millimetres.block_materials[0].youngs_modulus, 2e4);
  EXPECT_NEAR(in_millimetres.block_materials[0].density / 2.6e-9, 1, 1e-15);
  EXPECT_NEAR(in_millimetres.joint_materials[1].cohesion, 0.01, 1e-15);
}

TEST(CaseValues, names_stand_for_numbers_of_materials) {
  const Content content = read({"f", case_of(kMetre, kRock, kJoint, kRatio)}).content;
  EXPECT_EQ(content.blocks->blocks[0].material, 0);
  EXPECT_EQ(content.blocks->blocks[0].outer[0].joint_material, 1);
  EXPECT_EQ(content.blocks->blocks[0].outer[1].joint_material, 0);
}

TEST(CaseValues, faults_are_named_where_they_stand) {
  const std::string wrong_kind = R"({"name": "granite rock", "density": 1, "youngs_modulus": "20 m"})";
  EXPECT_EQ(error_of(case_of(kMetre, wrong_kind, kJoint, kRatio)),
            "f:4:80: error: expected youngs_modulus: a number, or a stress, such as \"20 GPa\", found \"20 m\"");
  const std::string unnamed = R"({"name": "granit rock", "density": 1, "youngs_modulus": 1})";
  EXPECT_EQ(error_of(case_of(kMetre, unnamed, kJoint, kRatio)),
            "f:2:37: error: expected the number or the name of a block material, one of granit rock; did you mean "
            "\"granit rock\"?, found \"granite rock\"");
  EXPECT_NE(error_of(case_of("{}", kRock, kJoint, kRatio)).find("time_step: a number, or the section \"units\""),
            std::string::npos);
  EXPECT_NE(error_of(case_of(kMetre, kRock, R"({"name": "bedding", "like": "granite_jiont"})", kRatio))
                .find("did you mean \"granite_joint\"?"),
            std::string::npos);
}

namespace {

// Two bolts of the geometry and one of a stage, all with names but the second.
std::string bolted(const std::string& removed, const std::string& third = "\"tie\"", const std::string& history = "2") {
  return R"({"keyblock": 1, "blocks": {"blocks": [{"outer": [[0, 0, 1], [4, 0, 1], [4, 1, 1], [0, 1, 1]]},
   {"outer": [[1, 1, 1], [3, 1, 1], [3, 2, 1], [1, 2, 1]]}], "fixed_points": [[0.1, 0.1, 1], [3.9, 0.1, 1]],
   "bolts": [[1.5, 0.5, 1.5, 1.5, 1, 2, 1e6, 0, 100, "left, \u00e4"], [2, 0.5, 2, 1.5, 1, 2, 1e6, 0, 200]]},
 "stages": [{"steps": 2, "bolts": [[2.5, 0.5, 2.5, 1.5, 1e6, 0, 300, 1, )" +
         third + R"(]]},
  {"steps": 2, "removed_bolts": [[)" +
         removed + R"(]]}], "outputs": {"histories": [{"bolt": )" + history + R"(}]},
 "analysis": {"step_count": 4, "time_step": 0.001, "allowed_displacement_ratio": 0.01, "velocity_carry_over": 1,
  "gravity": 9.81, "block_materials": [{"density": 2600, "youngs_modulus": 1e9}],
  "joint_materials": [{"friction_angle_deg": 30}]}})";
}

}  // namespace

TEST(CaseValues, bolts_have_names_that_stand_for_their_numbers) {
  const Content content = read({"f", bolted(R"("tie")", R"("tie")", R"("left, ä")")}).content;
  EXPECT_EQ(content.blocks->bolts[0].name.value_or({}), "left, ä");
  EXPECT_FALSE(content.blocks->bolts[1].name);
  EXPECT_EQ(content.stages.at(0).bolts[0].name.value_or({}), "tie");
  EXPECT_EQ(content.stages.at(1).removed_bolts[0].bolt, 2);
  EXPECT_EQ(content.outputs->histories[0].bolt, 0);
  const std::string written = kKeyblockCase.write(content);
  const Content again = read({"g", written}).content;
  EXPECT_EQ(again.blocks->bolts[0].name.value_or({}), "left, ä");
  EXPECT_EQ(again.stages.at(0).bolts[0].name.value_or({}), "tie");
  EXPECT_EQ(again.stages.at(1).removed_bolts[0].bolt, 2);
}

TEST(CaseValues, names_of_bolts_that_cannot_be_are_refused_where_they_stand) {
  EXPECT_EQ(
      error_of(bolted(R"("tei")")),
      "f:5:35: error: expected the number or the name of a bolt, one of left, ä, tie; did you mean \"tie\"?, found "
      "\"tei\"");
  EXPECT_NE(error_of(bolted("1", R"("left, ä")")).find("f:4:73: error: expected another name for each of the bolts"),
            std::string::npos)
      << error_of(bolted("1", R"("left, ä")"));
  EXPECT_NE(error_of(bolted("1", "7")).find("expected name of bolts: a word, found 7"), std::string::npos)
      << error_of(bolted("1", "7"));
  EXPECT_NE(error_of(bolted("1", R"("")")).find("a word that is not empty"), std::string::npos);
}

TEST(CaseValues, names_of_bolts_are_told_in_tables_and_pictures) {
  const std::string folder = support::fresh_folder("named_bolts");
  support::write_text(folder + "/case.json", bolted(R"("left, ä")", R"("tie")", R"("tie")"));
  const support::ProgramRun run = support::run_keyblock({"run", folder + "/case.json", "-o", folder + "/out"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  const std::string bolts = support::read_text(folder + "/out/bolts.csv");
  EXPECT_NE(bolts.find(",is_broken,name\n"), std::string::npos) << bolts;
  EXPECT_NE(bolts.find(",0,\"left, ä\"\n"), std::string::npos) << bolts;
  EXPECT_NE(bolts.find(",0,\n"), std::string::npos) << bolts;
  const std::string last = bolts.substr(bolts.rfind("\n4,") + 1);
  EXPECT_EQ(last.find("left"), std::string::npos) << last;
  EXPECT_NE(last.find(",tie\n"), std::string::npos) << last;
  EXPECT_NE(support::read_text(folder + "/out/histories.csv").find(",bolt,tie,force,"), std::string::npos);
  const std::string picture = support::read_text(folder + "/out/picture.svg");
  EXPECT_NE(picture.find(">tie</text>"), std::string::npos);
}

// Settings are texts: those that look like numbers stay unchanged.
TEST(CaseValues, settings_are_left_alone) {
  std::string text = case_of(kMetre, kRock, kJoint, kRatio);
  text.insert(1, R"("run": {"set": {"time_step": "0.001", "gravity": "9.81"}}, )");
  EXPECT_EQ(read({"f", text}).content.choices->settings[1].second, "9.81");
}

TEST(CaseValues, settings_may_be_numbers_and_flags) {
  std::string text = case_of(kMetre, kRock, kJoint, kRatio);
  text.insert(
      1,
      R"("run": {"set": {"time_step": 0.001, "steps": 2000000, "ledger": false, "quirk.fixed_pass_bound": true}}, )");
  using Settings = std::vector<std::pair<std::string, std::string>>;
  const Settings expected{
      {"time_step", "0.001"}, {"steps", "2000000"}, {"ledger", "off"}, {"quirk.fixed_pass_bound", "on"}};
  EXPECT_EQ(read({"f", text}).content.choices->settings, expected);
}

TEST(CaseValues, settings_that_are_no_value_are_refused_where_they_stand) {
  for (const auto& [value, found] : {std::pair{"null", "null"}, {"[1]", "an array"}, {"{}", "an object"}}) {
    std::string text = case_of(kMetre, kRock, kJoint, kRatio);
    text.insert(1, std::string(R"("run": {"set": {"time_step": )") + value + "}}, ");
    EXPECT_EQ(error_of(text), std::string("f:1:31: error: expected time_step of set: a word in quotes, a number, true "
                                          "or false, found ") +
                                  found);
  }
}

TEST(CaseValues, a_schema_is_passed_over_and_a_last_comma_too) {
  EXPECT_EQ(error_of(R"({"$schema": "x.json", "keyblock": 1, // a comment, with a comma
   "motion": [[0, 1, 2,], [1, 0, 0] , /* , */ ], })"),
            "");
  EXPECT_NE(error_of(R"({"keyblock": 1, "motion": [,]})"), "");
  EXPECT_NE(error_of(R"({"keyblock": 1,, "motion": []})"), "");
}

// Kulhawy (1978) has 52.7 GPa for granite, Barton & Choubey (1977) 31 to 35 degrees for its joints.
TEST(CaseValues, a_material_may_be_like_one_of_the_library) {
  const std::string rock = R"({"name": "granite rock", "like": "granite", "density": 2700})";
  const std::string joint = R"({"name": "bedding", "like": "granite_joint"})";
  const Analysis analysis = *read({"f", case_of(kMillimetre, rock, joint, kRatio)}).content.analysis;
  EXPECT_DOUBLE_EQ(analysis.block_materials[0].youngs_modulus, 52700);
  EXPECT_DOUBLE_EQ(analysis.block_materials[0].density, 2700);  // the value beside it has priority
  EXPECT_DOUBLE_EQ(analysis.joint_materials[1].friction_angle_deg, 33);
}

TEST(CaseValues, the_library_is_printed_as_documented) {
  const std::string page = support::read_text(KEYBLOCK_SOURCE_DIR "/formats/case_file/README.md");
  EXPECT_NE(page.find(library_tables()), std::string::npos) << library_tables();
}

TEST(CaseValues, version_2_has_the_defaults_of_today_and_says_so) {
  const Reading today = read({"f", case_of(kMillimetre, kRock, kJoint, "", 2)});
  EXPECT_EQ(today.content.analysis->velocity_carry_over, 1);
  EXPECT_TRUE(today.content.analysis->plane_strain);
  EXPECT_EQ(today.content.analysis->allowed_displacement_ratio, 0.01);
  EXPECT_NEAR(*today.content.analysis->gravity, 9810, 1e-9);  // mm/s²
  ASSERT_EQ(today.warnings.size(), 1U);
  EXPECT_EQ(today.warnings[0].name, "defaults_taken");
  const std::string said = R"("velocity_carry_over": 0, "plane_strain": false, "gravity": 1,)" + kRatio;
  const Reading told = read({"f", case_of(kMetre, kRock, kJoint, said, 2)});
  EXPECT_EQ(told.content.analysis->velocity_carry_over, 0);
  EXPECT_EQ(*told.content.analysis->gravity, 1);
  EXPECT_TRUE(told.warnings.empty());
  EXPECT_NE(error_of(case_of(kMetre, kRock, kJoint)).find("the key allowed_displacement_ratio of analysis"),
            std::string::npos)
      << "version 1 keeps its defaults";
}

TEST(CaseValues, a_case_names_its_drawing) {
  const std::string folder = support::fresh_folder("named_drawing");
  const std::string drawing = KEYBLOCK_SOURCE_DIR "/legacy_cases/sliding_block/a30_p20/a30_p20.geo";
  support::write_text(folder + "/plane.geo", support::read_text(drawing));
  std::string text = case_of(kMetre, kRock, kJoint, kRatio);
  const std::size_t blocks = text.find("\"blocks\": {");
  text.replace(blocks, text.find("\"analysis\"") - blocks, "\"drawing\": \"plane.geo\", ");
  support::write_text(folder + "/case.json", text);
  const Case loaded = load_case({folder + "/case.json"});
  ASSERT_TRUE(std::holds_alternative<Drawing>(loaded.problem.geometry));
  EXPECT_EQ(std::get<Drawing>(loaded.problem.geometry).joints.size(), 7U);
  EXPECT_EQ(loaded.files.size(), 2U);
  std::filesystem::remove(folder + "/plane.geo");
  const auto refused = [&](const std::string& name) {
    std::string named = text;
    named.replace(named.find("plane.geo"), 9, name);
    support::write_text(folder + "/case.json", named);
    try {
      load_case({folder + "/case.json"});
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder.size() + 1);
    }
    return std::string();
  };
  const std::string wanted =
      "case.json:2:13: error: expected the name of a drawing in the folder of the case, such as \"slope.dxf\", found ";
  EXPECT_EQ(refused("plane.geo"), wanted + "\"plane.geo\": there is no file " + folder + "/plane.geo");
  EXPECT_EQ(refused("."), wanted + "the folder \".\"");
  support::write_text(folder + "/other.json", R"({"keyblock": 1, "units": {"length": "m"}})");
  EXPECT_EQ(refused("other.json"), wanted + "\"other.json\", a Keyblock case file without one");
  EXPECT_EQ(refused(""),
            "case.json:2:13: error: expected drawing: the name of a file, such as \"slope.dxf\", found \"\"");
}

}  // namespace keyblock::formats::case_values_test
