// `keyblock new` writes cases that run, and whose results agree with their comments.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::new_command_test {
namespace {

using support::ProgramRun;
using support::read_text;
using support::run_keyblock;

/// Writes, runs and reads a case.
nlohmann::json run_of(const std::string& name) {
  const std::string folder = support::fresh_folder("new_" + name);
  const std::string file = folder + "/" + name + ".json";
  const ProgramRun made = run_keyblock({"new", name, "-o", file});
  EXPECT_EQ(made.exit_code, 0) << made.messages;
  const ProgramRun run = run_keyblock({"run", file, "-o", folder + "/out", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  return nlohmann::json::parse(run.output, nullptr, false);
}

}  // namespace

TEST(NewCommand, every_kind_runs_to_a_good_end) {
  for (const char* name : {"slope", "arch", "tunnel"}) {
    const auto record = run_of(name);
    EXPECT_EQ(record["outcome"]["end"], "finished") << name;
    EXPECT_EQ(record["profile"], "standard") << name;
  }
}

TEST(NewCommand, what_ends_in_yaml_is_yaml_and_says_the_same) {
  const std::string folder = support::fresh_folder("new_yaml");
  for (const char* name : {"slope", "arch", "beam", "tunnel", "block"}) {
    const std::string json = folder + "/" + name + ".json", yaml = folder + "/" + name + ".yaml";
    ASSERT_EQ(run_keyblock({"new", name, "-o", json}).exit_code, 0);
    ASSERT_EQ(run_keyblock({"new", name, "-o", yaml}).exit_code, 0);
    EXPECT_NE(read_text(yaml).find("\n# Editors complete"), std::string::npos) << name;
    const auto seen = [](const std::string& file) {
      const ProgramRun check = run_keyblock({"check", file, "--trial", "0", "--json"});
      EXPECT_EQ(check.exit_code, 0) << file << check.messages;
      auto report = nlohmann::json::parse(check.output, nullptr, false)["case"];
      for (auto& warning : report["warnings"]) warning = warning["sentence"];
      return report;
    };
    EXPECT_EQ(seen(json), seen(yaml)) << name;
  }
}

TEST(NewCommand, strict_json_is_read_by_any_parser_and_says_the_same) {
  const std::string folder = support::fresh_folder("new_strict");
  for (const char* name : {"slope", "arch", "beam", "tunnel", "block"}) {
    const std::string usual = folder + "/" + name + ".json", strict = folder + "/" + name + "_strict.json";
    ASSERT_EQ(run_keyblock({"new", name, "-o", usual}).exit_code, 0);
    ASSERT_EQ(run_keyblock({"new", name, "--strict-json", "-o", strict}).exit_code, 0);
    EXPECT_TRUE(nlohmann::json::accept(read_text(strict))) << name;
    EXPECT_EQ(nlohmann::json::parse(read_text(usual), nullptr, false, true).is_discarded(), true)
        << name << " has trailing commas";
    const auto blocks = [](const std::string& file) {
      const ProgramRun check = run_keyblock({"check", file, "--trial", "0", "--json"});
      EXPECT_EQ(check.exit_code, 0) << check.messages;
      return nlohmann::json::parse(check.output, nullptr, false)["case"]["blocks"];
    };
    EXPECT_EQ(blocks(usual), blocks(strict)) << name;
  }
}

// Arch and slope are stable: no displacement exceeds the deformation of their joints.
TEST(NewCommand, what_ought_to_stand_stands) {
  for (const char* name : {"slope", "arch"})
    EXPECT_LT(run_of(name)["extremes"]["greatest_displacement"]["value"].get<double>(), 0.01) << name;
}

TEST(NewCommand, the_block_slides_as_its_comment_says) {
  const double angle = 30 * std::numbers::pi / 180;
  const double theory = 9.81 / 2 * (std::sin(angle) - std::cos(angle) * std::tan(angle * 2 / 3));
  const auto record = run_of("block");
  EXPECT_NEAR(record["extremes"]["greatest_displacement"]["value"].get<double>() / theory, 1, 1e-3);
  EXPECT_NEAR(theory, 0.906, 5e-4);
}

// Bernoulli's beam in plane strain, w l⁴ / (8 E' I); shear adds about E' / (k G) (h/l)² / 2, 1.5 %.
TEST(NewCommand, the_beam_bends_as_its_comment_says) {
  const double w = 2350 * 9.81;
  const double theory = w * 1e4 / (8 * 14.7e9 / (1 - 0.04) / 12);
  const auto record = run_of("beam");
  EXPECT_NEAR(record["extremes"]["greatest_displacement"]["value"].get<double>() / theory, 1, 0.03);
  EXPECT_NEAR(theory, 0.0226, 5e-5);
}

TEST(NewCommand, no_file_is_overwritten_unless_told) {
  const std::string file = support::fresh_folder("new_twice") + "/folder/that/is/new/block.json";
  ASSERT_EQ(run_keyblock({"new", "block", "-o", file}).exit_code, 0);
  support::write_text(file, "mine");
  const ProgramRun again = run_keyblock({"new", "block", "-o", file});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_NE(again.messages.find("--force"), std::string::npos) << again.messages;
  EXPECT_EQ(read_text(file), "mine");
  EXPECT_EQ(run_keyblock({"new", "block", "-o", file, "--force"}).exit_code, 0);
  EXPECT_NE(read_text(file).find("\"keyblock\": 2"), std::string::npos);
  EXPECT_EQ(run_keyblock({"new", "bridge"}).exit_code, 2);
}

}  // namespace keyblock::new_command_test
