// `keyblock formats` and `keyblock info` list every format with its properties, one with a sample, and the layout of
// the case file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "formats/registry.hpp"
#include "tests/support/program.hpp"

namespace keyblock::formats_command_test {
namespace {

using support::ProgramRun;
using support::run_keyblock;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(FormatsCommand, every_format_is_listed) {
  const ProgramRun table = run_keyblock({"formats"});
  EXPECT_EQ(table.exit_code, 0);
  const auto json = nlohmann::json::parse(run_keyblock({"formats", "--json"}).output);
  ASSERT_EQ(json.size(), formats::all_formats().size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const formats::Format& format = *formats::all_formats()[i];
    EXPECT_TRUE(contains(table.output, "\n" + std::string(format.name) + " ")) << format.name;
    EXPECT_EQ(json[i]["name"], format.name);
    EXPECT_EQ(json[i]["reads"], format.read != nullptr);
    EXPECT_EQ(json[i]["writes"], format.write != nullptr);
    EXPECT_FALSE(json[i]["evidence"].get<std::string>().empty()) << format.name;
  }
  EXPECT_EQ(run_keyblock({"info"}).output, table.output);
}

TEST(FormatsCommand, one_format_has_a_sample) {
  const ProgramRun run = run_keyblock({"formats", "dda-geometry"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(contains(run.output, "reads: yes, writes: yes")) << run.output;
  EXPECT_TRUE(contains(run.output, "a sample:\n\n")) << run.output;
  EXPECT_EQ(run_keyblock({"formats", "no-such"}).exit_code, 2);
}

TEST(FormatsCommand, one_part_at_a_time_is_printed) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--schema", "--materials"},
                                                                                     {"--schema", "dxf"},
                                                                                     {"--materials", "dxf"},
                                                                                     {"--schema", "--joint-schema"},
                                                                                     {""}}) {
    std::vector<std::string> command{"formats"};
    command.insert(command.end(), words.begin(), words.end());
    const ProgramRun run = run_keyblock(command);
    EXPECT_EQ(run.exit_code, 2) << words.front();
    EXPECT_TRUE(run.output.empty()) << run.output;
  }
  EXPECT_TRUE(contains(run_keyblock({"formats", "DXF"}).messages, "did you mean \"dxf\"?"));
}

// Granite of the library: 2650 kg/m3 and 52.7 GPa.
TEST(FormatsCommand, the_library_of_materials_is_a_table_or_json) {
  const auto json = nlohmann::json::parse(run_keyblock({"formats", "--materials", "--json"}).output);
  EXPECT_EQ(json["block_materials"][0]["like"], "granite");
  EXPECT_EQ(json["block_materials"][0]["density"], 2650);
  EXPECT_NEAR(json["block_materials"][0]["youngs_modulus"].get<double>(), 52.7e9, 1);
  EXPECT_GT(json["joint_materials"].size(), 3U);
  EXPECT_TRUE(contains(run_keyblock({"formats", "--materials"}).output, "| `granite` | 2650 | 52.7 |"));
}

TEST(FormatsCommand, the_schema_is_json) {
  const auto schema = nlohmann::json::parse(run_keyblock({"formats", "--schema"}).output);
  EXPECT_TRUE(schema["properties"].contains("analysis"));
}

}  // namespace keyblock::formats_command_test
