// One body as a block, in a single triangle of covers, on a mesh of covers, and solved linearly. All four runs write
// the same files with the same columns, and frames with the same data of cells.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::same_files_test {
namespace {

using support::fresh_folder;
using support::read_text;
using support::run_keyblock;
using support::write_text;

struct Way {
  std::string name;
  std::string covers;        ///< section of the case file; empty: a block
  std::string fixed_points;  ///< of a block; NMM bodies are fixed along their base
  bool is_static = false;
};

const std::string kHeld = R"("displacements": [{"along": [[0, 0], [1, 0]]}])";

const std::vector<Way> kWays{
    {"block", "", "[[0.1, 0, 1]]"},
    {"one_triangle", R"(, "covers": {"functions": "constant", "mesh": {"side": 9}, )" + kHeld + "}", "[]"},
    {"mesh", R"(, "covers": {"functions": "derived", "mesh": {"side": 0.4}, )" + kHeld + "}", "[]"},
    {"at_once", R"(, "covers": {"functions": "derived", "mesh": {"side": 0.4}, )" + kHeld + "}", "[]", true}};

std::string text_of(const Way& way) {
  return R"({"keyblock": 1, "blocks": {"blocks": [
    {"material": 1, "outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]}],
    "measured_points": [[0.5, 1, 1]], "fixed_points": )" +
         way.fixed_points + R"(}, "analysis": {"velocity_carry_over": )" + (way.is_static ? "0" : "1") +
         R"(, "step_count": 3, "time_step": 0.001, "gravity": 9.81, "allowed_displacement_ratio": 1, "block_materials":
    [{"density": 2500, "unit_weight": 24525, "youngs_modulus": 1e9, "poissons_ratio": 0.2}], "joint_materials":
    [{"friction_angle_deg": 0, "cohesion": 0, "tensile_strength": 0}], "penalty_factor": 10})" +
         way.covers + "}";
}

/// Outputs of a run of the body.
struct Left {
  std::set<std::string> files;  ///< without the picture of energies, for linear statics has no energy balance
  std::set<std::string> keys;   ///< of run.json
  std::set<std::string> settings;
  std::vector<std::string> heads;  ///< of the tables
  std::set<std::string> cells;     ///< data of a frame's cells
};

std::set<std::string> keys_of(const nlohmann::json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

/// Without the reactions, which come last if load steps sum them.
std::string first_line(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  return line.substr(0, line.find(",reaction1"));
}

Left left_by(const Way& way) {
  const std::string folder = fresh_folder("same_files_" + way.name);
  write_text(folder + "/in.json", text_of(way));
  const auto run = run_keyblock({"run", folder + "/in.json", "-o", folder + "/out", "--trace", "--frames", "text"});
  EXPECT_EQ(run.exit_code, 0) << way.name << run.messages;
  const auto record = nlohmann::json::parse(read_text(folder + "/out/run.json"));
  Left left;
  for (const auto& name : record.at("outputs")) left.files.insert(name.get<std::string>());
  left.files.erase("energy.svg");  // linear statics has no energy balance
  left.files.erase("ledger.csv");
  left.keys = keys_of(record);
  left.settings = keys_of(record.at("settings"));
  for (const char* table : {"history.csv", "points.csv", "steps.csv", "blocks.csv"})
    left.heads.push_back(first_line(read_text(folder + "/out/" + table)));
  pugi::xml_document frame;
  EXPECT_TRUE(frame.load_file((folder + "/out/frames/00000003.vtu").c_str()));
  const pugi::xml_node piece = frame.child("VTKFile").child("UnstructuredGrid").child("Piece");
  for (const pugi::xml_node& array : piece.child("CellData")) left.cells.insert(array.attribute("Name").value());
  // Displacement of corners of all bodies; stress of corners if it varies between them: not of constant functions.
  const pugi::xml_node points = piece.child("PointData");
  EXPECT_TRUE(points.find_child_by_attribute("Name", "displacement"));
  EXPECT_EQ(!points.find_child_by_attribute("Name", "stress_xx").empty(),
            way.covers.find("derived") != std::string::npos);
  return left;
}

}  // namespace

TEST(SameFiles, whatever_a_body_hangs_on) {
  const Left block = left_by(kWays.front());
  EXPECT_TRUE(block.files.contains("points.csv") && block.files.contains("field.svg"));
  for (const Way& way : kWays) {
    const Left left = left_by(way);
    EXPECT_EQ(left.files, block.files) << way.name;
    EXPECT_EQ(left.settings, block.settings) << way.name;
    EXPECT_EQ(left.heads, block.heads) << way.name;
    for (const std::string& name : block.cells) EXPECT_TRUE(left.cells.contains(name)) << way.name << ": " << name;
    for (const std::string& key : block.keys)
      EXPECT_TRUE(key == "ledger" || left.keys.contains(key)) << way.name << ": " << key;
  }
}

}  // namespace keyblock::same_files_test
