// Drawings with layers of any name, read by `--layers` or by the case file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::layers_command_test {
namespace {

using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using support::write_text;

const std::string kDocs = KEYBLOCK_SOURCE_DIR "/docs/";
const std::string kTable = kDocs + "quarry_layers.csv";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Returns the drawing as a case file.
std::string converted(const std::string& folder, std::vector<std::string> inputs) {
  const std::string out = folder + "/" + std::to_string(inputs.size()) + ".json";
  inputs.insert(inputs.begin(), "convert");
  inputs.insert(inputs.end(), {"-o", out, "--force"});
  const ProgramRun run = run_keyblock(inputs);
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  return read_text(out);
}

}  // namespace

TEST(LayersCommand, the_example_of_docs_is_the_drawing_that_has_the_names) {
  const std::string folder = fresh_folder("layers");
  const std::string by_names = converted(folder, {kDocs + "bench.dxf"});
  EXPECT_FALSE(by_names.empty());
  EXPECT_EQ(converted(folder, {kDocs + "quarry.dxf", "--layers", kTable}), by_names);
  const ProgramRun without = run_keyblock({"check", kDocs + "quarry.dxf"});
  EXPECT_TRUE(contains(without.output, "dxf_layer_as_joints")) << without.output;
  const ProgramRun with = run_keyblock({"check", kDocs + "quarry.dxf", "--layers", kTable});
  EXPECT_FALSE(contains(with.output, "dxf_layer")) << with.output;
}

// A case converted alone keeps the meaning of the layers of a drawing beside it.
TEST(LayersCommand, a_case_converted_without_its_drawing_keeps_its_layers) {
  const std::string folder = fresh_folder("layers_kept");
  std::string text = read_text(kDocs + "bench.json");
  text.insert(text.find("\"analysis\""), R"("layers": {"Contour": "boundary", "Gauge": "measured"}, )");
  write_text(folder + "/case.json", text);
  const std::string out = converted(folder, {folder + "/case.json"});
  EXPECT_TRUE(contains(out, "\"Contour\": \"boundary\"")) << out;
  EXPECT_TRUE(contains(out, "\"Gauge\": \"measured\"")) << out;
}

TEST(LayersCommand, a_case_file_says_it_too_and_the_option_counts) {
  const std::string folder = fresh_folder("layers_case");
  std::filesystem::copy_file(kDocs + "quarry.dxf", folder + "/quarry.dxf");
  std::string text = read_text(kDocs + "bench.json");
  text.insert(text.find("\"analysis\""),
              R"("drawing": "quarry.dxf", "layers": {"Contour": "boundary", "Bedding": "joint 2",
    "Cross joints": "joint 2", "Support": "fixed", "Gauge": "measured", "Sheet frame": "ignored"}, )");
  write_text(folder + "/case.json", text);
  const auto materials_of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"convert", folder + "/case.json", "-o", folder + "/out.json", "--force"};
    all.insert(all.end(), more.begin(), more.end());
    const ProgramRun run = run_keyblock(all);
    EXPECT_EQ(run.exit_code, 0) << run.messages;
    const std::string drawing = read_text(folder + "/out.json");
    // Rows of joints end in their material; the outline has 1.
    return std::ranges::count(drawing, '\n') > 0 ? contains(drawing, ", 2]") : false;
  };
  EXPECT_TRUE(materials_of({}));
  write_text(folder + "/ones.csv", "layer,part\nBedding,joint 1\nCross joints,joint 1\n");
  EXPECT_FALSE(materials_of({"--layers", folder + "/ones.csv"}));
}

TEST(LayersCommand, wrong_rows_are_one_clear_error) {
  const std::string folder = fresh_folder("layers_wrong");
  write_text(folder + "/wrong.csv", "layer,part\nContour,boundary\nBedding,jiont 1\nSupport,held\n");
  const ProgramRun wrong = run_keyblock({"check", kDocs + "quarry.dxf", "--layers", folder + "/wrong.csv"});
  EXPECT_EQ(wrong.exit_code, 3);
  EXPECT_EQ(std::ranges::count(wrong.messages, '\n'), 1) << wrong.messages;
  EXPECT_TRUE(
      contains(wrong.messages, "wrong.csv:3:1: error: expected a part for layer \"Bedding\": boundary, joint N"))
      << wrong.messages;
  EXPECT_TRUE(contains(wrong.messages, "did you mean \"joint\"?")) << wrong.messages;
  const ProgramRun other = run_keyblock({"check", kDocs + "quarry.dxf", "--layers", kDocs + "bench.json"});
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_TRUE(contains(other.messages, "expected a table of layers, whose first line is layer,part")) << other.messages;
  write_text(folder + "/case.json", R"({"keyblock": 2, "layers": {"Contour": "outlin"}})");
  const ProgramRun in_case = run_keyblock({"check", kDocs + "quarry.dxf", folder + "/case.json"});
  EXPECT_EQ(in_case.exit_code, 3);
  EXPECT_TRUE(contains(in_case.messages, "case.json:1:28: error: expected a part for layer \"Contour\""))
      << in_case.messages;
}

}  // namespace keyblock::layers_command_test
