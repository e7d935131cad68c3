// `element` and `fit`: their refusals and warnings, and the files that each reads of the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "formats/text/csv.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::rock_commands_test {
namespace {

using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using support::write_text;

std::string case_with(const std::string& strength, bool plane_strain = true) {
  return R"({"keyblock": 1, "blocks": {"blocks": [{"outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1]]}]},
    "analysis": {"step_count": 1, "time_step": 1, "allowed_displacement_ratio": 0.1, "gravity": 0, "plane_strain": )" +
         std::string(plane_strain ? "true" : "false") + R"(, "joint_materials": [{}], "block_materials": [
    {"density": 1, "unit_weight": 0, "youngs_modulus": 1e5, "poissons_ratio": 0.3, "strength": )" +
         strength + "}]}}";
}

const std::string kTresca = R"({"surface": "tresca", "cohesion": 20})";

struct Bench {
  std::string folder;

  explicit Bench(const std::string& name, const std::string& text = case_with(kTresca))
      : folder(fresh_folder("rock_commands_" + name)) {
    write_text(folder + "/case.json", text);
  }
  ProgramRun element(std::vector<std::string> more) const {
    more.insert(more.begin(), {"element", folder + "/case.json"});
    return run_keyblock(more);
  }
};

bool says(const ProgramRun& run, const std::string& words) {
  return run.messages.find(words) != std::string::npos;
}

}  // namespace

TEST(RockCommands, element_refuses_what_is_no_strain_or_is_not_read) {
  const Bench bench("refused");
  write_text(bench.folder + "/path.csv", "eyy\n-0.01\n");
  write_text(bench.folder + "/far.csv", "exx,eyy\n0,-0.01\n0,1e300\n");
  const std::string path = bench.folder + "/path.csv";
  for (const auto& [arguments, words] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--to=1e300"}, "--to: expected a number from -10 to 10"},
           {{"--to=nan"}, "--to: expected a number from -10 to 10"},
           {{"--path", "triaxial", "--confining", "inf"}, "--confining: expected a number"},
           {{"--confining", "3"}, "--confining: expected none with --path uniaxial"},
           {{"--path", path, "--to=-0.01"}, "--to: expected none"},
           {{"--path", path, "--cycles", "2"}, "--cycles: expected none"},
           {{"--material", "0"}, "--material: expected a number above 0, found \"0\""},
           {{"--size", "0"}, "--size: expected a number above 0, found \"0\""},
           {{"--path", "cyclic", "--cycles", "10000", "--steps", "1000000"},
            "--steps: expected at most 1e+07 points of a curve, found 2e+10 of 20000 legs of 1000000 steps"},
           {{"--path", "round"}, "shear, cyclic or a file .csv, found \"round\""}}) {
    const ProgramRun run = bench.element(arguments);
    EXPECT_EQ(run.exit_code, 2) << run.messages;
    EXPECT_TRUE(says(run, words)) << run.messages;
  }
  const ProgramRun far = bench.element({"--path", bench.folder + "/far.csv"});
  EXPECT_EQ(far.exit_code, 3);
  EXPECT_TRUE(says(far, "far.csv:3:3: error: expected eyy from -10 to 10, found 1e+300")) << far.messages;
}

// Uniaxial strength 2 c at both reversals. Between them the elastic strain 2 · 2 c/E is given back, so that each leg
// adds its plastic strain to κ: the first 0.01 - 40/E, those after it 0.012 - 80/E. In uniaxial stress, flow of Tresca
// in an edge has equal lateral strains at constant volume: κ then grows by the axial plastic strain.
TEST(RockCommands, a_cyclic_path_goes_to_and_fro_between_its_targets) {
  const Bench bench("cyclic");
  const std::string out = bench.folder + "/curve.csv";
  ASSERT_EQ(bench.element({"--path", "cyclic", "--to=-0.01,0.002", "--cycles", "3", "-o", out}).exit_code, 0);
  const formats::CsvTable table = formats::read_csv({out, read_text(out)});
  const auto value = [&](const formats::CsvRow& row, const char* heading) {
    return formats::csv_real(table, row, formats::csv_column(table, heading));
  };
  std::vector<double> turns, stresses, kappas;
  for (std::size_t i = 1; i < table.rows.size(); ++i)
    if (i + 1 == table.rows.size() || value(table.rows[i + 1], "leg") != value(table.rows[i], "leg")) {
      turns.push_back(value(table.rows[i], "eyy"));
      stresses.push_back(value(table.rows[i], "syy"));
      kappas.push_back(value(table.rows[i], "kappa"));
    }
  ASSERT_EQ(turns.size(), 6U);
  double kappa = 0.01 - 40 / 1e5;
  for (std::size_t leg = 0; leg < 6; ++leg) {
    EXPECT_NEAR(turns[leg], leg % 2 == 0 ? -0.01 : 0.002, 1e-12);
    EXPECT_NEAR(stresses[leg], leg % 2 == 0 ? -40 : 40, 1e-9);
    EXPECT_NEAR(kappas[leg], kappa, 1e-9);
    kappa += 0.012 - 80 / 1e5;
  }
}

TEST(RockCommands, a_cyclic_path_with_one_target_comes_back_to_0) {
  const Bench bench("back");
  const ProgramRun run = bench.element({"--path", "cyclic", "--to=-0.0002", "--cycles", "2"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(says(run, "at the end strain 0, ") && says(run, "stress yy from -20 to ")) << run.messages;
}

// E of the case, and 2 c.
TEST(RockCommands, fit_reads_what_element_writes) {
  const Bench bench("round");
  const std::string out = bench.folder + "/curve.csv";
  ASSERT_EQ(bench.element({"--to=-0.001", "--steps", "50", "-o", out}).exit_code, 0);
  const ProgramRun run = run_keyblock({"fit", out, "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_NE(run.output.find("\"youngs_modulus\": 100000.0"), std::string::npos) << run.output;
  const ProgramRun minus = run_keyblock({"fit", out, "--material", "-"});
  EXPECT_EQ(minus.exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists("-"));
}

TEST(RockCommands, a_fit_of_another_shape_ends_with_1) {
  const Bench bench("poor");
  std::string text = "strain,stress\n";
  for (int i = 0; i < 20; ++i) text += std::to_string(i) + "," + std::to_string(i < 10 ? 3 * i : 60 - 3 * i) + "\n";
  write_text(bench.folder + "/peak.csv", text);
  const ProgramRun run = run_keyblock({"fit", bench.folder + "/peak.csv"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(says(run, "[softening]")) << run.messages;
  EXPECT_TRUE(says(run, "[poor_fit]")) << run.messages;
}

TEST(RockCommands, element_says_what_check_says_of_a_strength_and_that_plane_stress_is_not_read) {
  const Bench bench("warned", case_with(R"({"cohesion": 20, "friction_deg": 35, "dilation_deg": 0.61})", false));
  const ProgramRun run = bench.element({});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(says(run, "dilation_deg 0.61 with friction_deg 35 would be 35 degrees, were it in radians"))
      << run.messages;
  EXPECT_TRUE(says(run, "[plane_not_read]")) << run.messages;
  const ProgramRun checked = run_keyblock({"check", bench.folder + "/case.json", "--trial", "0"});
  EXPECT_NE(checked.output.find("would be 35 degrees"), std::string::npos) << checked.output;
  EXPECT_FALSE(says(Bench("strain").element({}), "plane_not_read"));
}

}  // namespace keyblock::rock_commands_test
