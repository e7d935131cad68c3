// `sif`, and runs with growing cracks, from the command line: tables, files, exit codes, bad input.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::sif_command_test {
namespace {

using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using support::write_text;
using Json = nlohmann::json;

const std::string kCases = KEYBLOCK_SOURCE_DIR "/legacy_cases/stress_intensity/";

/// A plate 1 by 2; `covers` and `material` added to the usual keys.
std::string plate(const std::string& covers, const std::string& material = "", int steps = 1) {
  return fmt::format(
      R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[0, -1, 1], [1, -1, 1], [1, 1, 1], [0, 1, 1]]}}]}},
    "covers": {{"contact": "ignored", {}}}, "analysis": {{"step_count": {}, "time_step": 1,
    "allowed_displacement_ratio": 0.1,
    "plane_strain": true, "joint_materials": [{{}}], "block_materials": [{{"density": 1, "unit_weight": 0,
    "youngs_modulus": 1e5, "poissons_ratio": 0.3{}}}]}}}})",
      covers, steps, material);
}

const std::string kPulled =
    R"("tractions": [{"along": [[0, 1], [1, 1]], "y": 1}, {"along": [[0, -1], [1, -1]], "y": -1}],
       "springs": [[1, -1, 1, 0, 1e5], [1, -1, 0, 1, 1e5], [1, 1, 1, 0, 1e5]])";

std::string file_of(const std::string& name, const std::string& text) {
  const std::string file = fresh_folder("sif_" + name) + "/in.json";
  write_text(file, text);
  return file;
}

Json tips_of(const std::string& file) {
  const ProgramRun run = run_keyblock({"sif", file, "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  return Json::parse(run.output).at("tips");
}

TEST(SifCommand, json_names_the_case_its_files_and_its_warnings) {
  const ProgramRun run = run_keyblock({"sif", kCases + "edge_crack_05", "--set", "restitution=0.5", "--plan"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  const Json json = Json::parse(run.output);
  EXPECT_EQ(json.at("program"), "keyblock");
  EXPECT_TRUE(json.at("case").get<std::string>().ends_with("edge_crack_05"));
  ASSERT_FALSE(json.at("inputs").empty());
  EXPECT_EQ(json.at("inputs")[0].at("sha256").get<std::string>().size(), 64U);
  EXPECT_TRUE(std::ranges::any_of(json.at("warnings"),
                                  [](const Json& warning) { return warning.at("name") == "setting_without_effect"; }));
}

// A node of the mesh lies on the tip, where functions of the root of the distance have no stress.
TEST(SifCommand, stress_in_frames_of_a_case_with_near_tip_functions_is_finite) {
  const std::string folder = fresh_folder("sif_finite") + "/out";
  const ProgramRun run = run_keyblock({"run", kCases + "centre_crack_functions", "-o", folder});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  int frames = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder + "/frames")) {
    const std::string text = read_text(file.path().string());
    EXPECT_EQ(text.find("nan"), std::string::npos) << file.path();
    EXPECT_EQ(text.find("inf"), std::string::npos) << file.path();
    ++frames;
  }
  EXPECT_GT(frames, 1);
}

TEST(SifCommand, prints_factors_of_every_domain_that_agree_with_theory) {
  const Json tip = tips_of(kCases + "edge_crack_05").at(0);
  const double exact = 2.82357 * std::sqrt(std::numbers::pi / 2);  // Tada, Paris & Irwin 1973; finite elements
  EXPECT_NEAR(tip.at("K_I").get<double>(), exact, 0.007 * exact);
  EXPECT_LT(tip.at("spread_K_I").get<double>(), 0.003);
  const double j = tip.at("J"), k = tip.at("K_I");
  EXPECT_NEAR(j, k * k * (1 - 0.09) / 1e5, 2e-3 * j);
  int used = 0;
  for (const Json& domain : tip.at("domains"))
    if (domain.contains("K_I") && domain.at("domain") != "1 level about the tip element" &&
        domain.at("domain") != "1 level about the nearest node") {
      ++used;
      EXPECT_NEAR(domain.at("K_I").get<double>(), k, 0.005 * k) << domain;
    }
  EXPECT_GE(used, 12);
}

// If a node lies on the tip, all elements about it hold the tip, and one of them the direction ahead. One and two
// levels about it are of the elements next to the tip, 2.4 % low without near-tip functions.
TEST(SifCommand, levels_about_the_tip_element_and_about_the_nearest_node_are_two_choices_and_both_agree_with_theory) {
  const double exact = 2.82357 * std::sqrt(std::numbers::pi / 2);
  for (const char* mesh : {R"("tip_side": 0.0016)", R"("tip_side": 0.04, "tip_functions": "williams")"}) {
    const std::string text = plate(R"("mesh": {"side": 0.1, "angle": 10, )" + std::string(mesh) +
                                   R"(}, "cracks": [{"along": [[0, 0], [0.5, 0]]}], )" + kPulled);
    const Json tip = tips_of(file_of("levels", text)).at(0);
    const auto factor = [&](int levels, const char* about) {
      const std::string name = fmt::format("{} levels about the {}", levels, about);
      for (const Json& domain : tip.at("domains"))
        if (domain.at("domain") == name && domain.contains("K_I")) return domain.at("K_I").get<double>();
      return 0.0;
    };
    for (const int levels : {3, 4}) {
      const double element = factor(levels, "tip element"), node = factor(levels, "nearest node");
      EXPECT_NE(element, node) << levels << mesh;
      EXPECT_NEAR(element, exact, 0.008 * exact) << levels << mesh;
      EXPECT_NEAR(node, exact, 0.008 * exact) << levels << mesh;
      EXPECT_NEAR(element, node, 0.004 * exact) << levels << mesh;
    }
  }
}

// Two fields without common functions at the tip: a mesh bisected towards it and near-tip functions. The program solves
// both; the case chooses which of them is its own.
TEST(SifCommand, both_treatments_of_a_tip_agree) {
  const double exact = 2.82357 * std::sqrt(std::numbers::pi / 2);
  const std::string crack = R"("cracks": [{"along": [[0, 0], [0.5, 0]]}], )";
  for (const char* mesh : {R"("tip_side": 0.0016)", R"("tip_side": 0.04, "tip_functions": "williams")",
                           R"("tip_side": 0.08, "tip_functions": "williams", "tip_radius": 0.3)"}) {
    const std::string text =
        plate(R"("mesh": {"side": 0.1, "angle": 10, )" + std::string(mesh) + "}, " + crack + kPulled);
    const Json tip = tips_of(file_of("both", text)).at(0);
    EXPECT_NEAR(tip.at("K_I").get<double>(), exact, 0.007 * exact) << mesh;
    const Json other = tip.at("other_treatment");
    EXPECT_NEAR(other.at("K_I").get<double>(), exact, 0.007 * exact) << mesh;
    EXPECT_LT(std::abs(other.at("difference_K_I").get<double>()), 0.01) << mesh;
    EXPECT_LT(std::abs(other.at("difference_K_II").get<double>()), 0.005) << mesh;
    EXPECT_NE(other.at("K_I"), tip.at("K_I")) << mesh;
    EXPECT_EQ(tip.at("side").get<double>() < 0.01, other.at("side").get<double>() > 0.01) << mesh;
  }
}

// fra-19 at friction 0.3, to 0.005 of s √(π c) by each treatment of the tips.
TEST(SifCommand, a_closed_crack_slips_as_far_by_both_treatments) {
  const double root = std::sqrt(std::numbers::pi);
  const Json tips = tips_of(kCases + "closed_crack_03_functions");
  ASSERT_EQ(tips.size(), 2U);
  for (const Json& tip : tips)
    for (const Json& treatment : {tip, tip.at("other_treatment")}) {
      EXPECT_EQ(treatment.at("K_I").get<double>(), 0);
      EXPECT_NEAR(treatment.at("K_II").get<double>(), -0.35 * root, 0.005 * root);
    }
}

TEST(SifCommand, near_tip_functions_bear_loads_on_the_faces) {
  const std::string mesh = R"("mesh": {"side": 0.1, "angle": 10, "tip_side": 0.05, "tip_functions": "williams"},
       "cracks": [{"along": [[0, 0], [0.5, 0]]}], )";
  const double exact = 2.82357 * std::sqrt(std::numbers::pi / 2);
  const Json tip = tips_of(file_of("function_faces", plate(mesh + R"("tractions": [{"along": [[0, 0], [0.5, 0]],
       "pressure": 1}], "springs": [[1, -1, 1, 0, 1e5], [1, -1, 0, 1, 1e5], [1, 1, 1, 0, 1e5]])")))
                       .at(0);
  EXPECT_NEAR(tip.at("K_I").get<double>(), exact, 0.005 * exact);
}

TEST(SifCommand, near_tip_functions_are_of_linear_statics_alone) {
  const std::string mesh =
      R"("mesh": {"side": 0.2, "tip_functions": "williams"}, "cracks": [{"along": [[0, 0], [0.5, 0]]}], )";
  const std::string text = plate(mesh + kPulled);
  const auto refused = [&](const std::string& name, std::string changed, const std::vector<std::string>& more,
                           const std::string& words) {
    const std::string out = fresh_folder("sif_refused_out") + "/out";
    std::vector<std::string> arguments{"run", file_of("refused_" + name, changed), "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = run_keyblock(arguments);
    EXPECT_EQ(run.exit_code, 3) << name;
    EXPECT_NE(run.messages.find("expected linear statics of elastic rock for tip_functions"), std::string::npos)
        << run.messages;
    EXPECT_NE(run.messages.find(words), std::string::npos) << run.messages;
    EXPECT_FALSE(std::filesystem::exists(out));
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    return changed;
  };
  const std::string felt = with(R"("contact": "ignored")", R"("contact": "felt")");
  const auto felt_with = [&](const std::string& from, const std::string& to) {
    std::string changed = felt;
    changed.replace(changed.find(from), from.size(), to);
    return changed;
  };
  refused("felt_by_two", felt_with(R"("blocks": [{)", R"("blocks": [{"outer": [[2, 0, 1], [3, 0, 1], [3, 1, 1]]}, {)"),
          {}, "found contact of several bodies");
  refused("felt_beside_points", felt_with(R"("blocks": [{)", R"("fixed_points": [[0.5, -0.5, 1]], "blocks": [{)"), {},
          "or contact with fixed points, loading points or bolts");
  refused("cohesion", felt_with(R"("joint_materials": [{}])", R"("joint_materials": [{"cohesion": 1}])"), {},
          "found cohesion or tensile strength of joints whose faces touch");
  refused("time", text, {"--set", "motion=dynamic"}, "found dynamics");
  refused("growth", with(R"("tractions")", R"("growth": {"increment": 0.1}, "tractions")"), {}, "found crack growth");
  refused("constant", with(R"("contact")", R"("functions": "constant", "contact")"), {}, "found constant functions");
  const std::string unasked = with(R"("tip_functions": "williams")", R"("tip_radius": 0.3)");
  const ProgramRun radius =
      run_keyblock({"run", file_of("refused_radius", unasked), "-o", fresh_folder("sif_refused_out") + "/out"});
  EXPECT_EQ(radius.exit_code, 3);
  EXPECT_NE(radius.messages.find("expected tip_functions"), std::string::npos) << radius.messages;
}

// Pressure on the faces instead of tension on the ends: the same K by superposition, if the faces are in the integrals.
TEST(SifCommand, loads_on_the_faces_are_part_of_the_integrals) {
  const std::string mesh =
      R"("mesh": {"side": 0.1, "angle": 10, "tip_side": 0.002}, "cracks": [{"along": [[0, 0], [0.5, 0]]}], )";
  const Json remote = tips_of(file_of("remote", plate(mesh + kPulled))).at(0);
  const Json faces =
      tips_of(file_of("faces", plate(mesh + R"("tractions": [{"along": [[0, 0], [0.5, 0]], "pressure": 1}],
       "springs": [[1, -1, 1, 0, 1e5], [1, -1, 0, 1, 1e5], [1, 1, 1, 0, 1e5]])")))
          .at(0);
  const double k = remote.at("K_I");
  EXPECT_NEAR(faces.at("K_I").get<double>(), k, 0.002 * k);
  for (const Json& domain : faces.at("domains"))
    if (domain.at("domain").get<std::string>().starts_with("circle") && domain.contains("K_I")) {
      EXPECT_NEAR(domain.at("K_I").get<double>(), k, 0.003 * k) << domain;
    }
}

// An initial stress that the faces of a new crack cannot carry opens it as the same tension does.
TEST(SifCommand, initial_stress_opens_a_crack_as_the_same_tension_does) {
  const std::string mesh =
      R"("mesh": {"side": 0.1, "angle": 10, "tip_side": 0.002}, "cracks": [{"along": [[0, 0], [0.5, 0]]}], )";
  const Json pulled = tips_of(file_of("pulled", plate(mesh + kPulled))).at(0);
  const Json stressed =
      tips_of(file_of("stressed", plate(mesh + R"("initial_stress_field": {"yy": 1}, )" + kPulled))).at(0);
  EXPECT_NEAR(stressed.at("K_I").get<double>(), pulled.at("K_I").get<double>(), 0.002 * pulled.at("K_I").get<double>());
}

TEST(SifCommand, a_tip_near_a_boundary_is_refused_with_its_name) {
  const std::string covers =
      R"("mesh": {"side": 0.1, "tip_side": 0.01}, "cracks": [{"along": [[0, 0], [0.999, 0.02]]}], )";
  const ProgramRun run = run_keyblock({"sif", file_of("near", plate(covers + kPulled))});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.output.find("the outline of a body is 0.001"), std::string::npos) << run.output;
}

TEST(SifCommand, bad_cracks_are_refused_and_nothing_is_written) {
  const std::vector<std::pair<std::string, std::string>> faults{
      {R"("cracks": [{"along": [[3, 0], [4, 0]]}])", "expected a crack in a body"},
      {R"("cracks": [{"along": [[0.2, 0], [0.2, 0]]}])", "twice in a row"},
      {R"("cracks": [{"along": [[0.2, 0]]}])", "expected 2 points at least along a crack"},
      {R"("cracks": [{"along": [[0.2, 0], [0.6, 0]]}, {"along": [[0.5, 0], [0.9, 0]]}])",
       "along a joint or another crack"},
      {R"("cracks": [{"along": [[0, 0], [0.5, 0]]}], "growth": {"increment": 0})", "increment"}};
  for (const auto& [cracks, words] : faults) {
    const std::string file = file_of("bad", plate(R"("mesh": {"side": 0.2}, )" + cracks + ", " + kPulled));
    const std::string out = fresh_folder("sif_bad_out") + "/out";
    const ProgramRun run = run_keyblock({"run", file, "-o", out});
    EXPECT_EQ(run.exit_code, 3) << cracks;
    EXPECT_NE(run.messages.find(words), std::string::npos) << run.messages;
    EXPECT_NE(run.messages.find("in.json:"), std::string::npos) << run.messages;
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

// A table of K from a run has no doubts of `sif`.
TEST(RunsWithCracks, tell_of_coarse_tips_and_of_tips_without_factors) {
  const auto said = [](const std::string& covers) {
    return run_keyblock(
        {"run", file_of("told", plate(covers + ", " + kPulled)), "-o", fresh_folder("sif_told_out") + "/out"});
  };
  const ProgramRun coarse = said(R"("mesh": {"side": 0.05}, "cracks": [{"along": [[0, 0], [0.5, 0]]}])");
  EXPECT_EQ(coarse.exit_code, 0) << coarse.messages;
  EXPECT_NE(coarse.messages.find("[coarse_tip]"), std::string::npos) << coarse.messages;
  const ProgramRun fine =
      said(R"("mesh": {"side": 0.2, "tip_side": 0.005}, "cracks": [{"along": [[0, 0], [0.5, 0]]}])");
  EXPECT_EQ(fine.messages.find("[coarse_tip]"), std::string::npos) << fine.messages;
  EXPECT_EQ(fine.messages.find("[tip_without_factors]"), std::string::npos) << fine.messages;
  const ProgramRun tiny = said(R"("mesh": {"side": 0.2}, "cracks": [{"along": [[0.5, 0], [0.5000001, 0]]}])");
  EXPECT_NE(tiny.messages.find("[tip_without_factors]"), std::string::npos) << tiny.messages;
  EXPECT_EQ(tiny.messages.find("[coarse_tip]"), std::string::npos) << tiny.messages;
}

// G of a beam driven by a displacement: half of the reaction times the displacement is its energy. Its loss is the sum
// of J over the path of the tip, both at one displacement.
TEST(CrackGrowth, releases_the_energy_that_j_says) {
  const std::string covers = R"("mesh": {"side": 0.2, "angle": 10}, "cracks": [{"along": [[0, 0], [2, 0]]}],
     "growth": {"increment": 0.2}, "displacements": [{"along": [[0, 0], [0, 1]], "held": "y", "y": 0.001},
       {"along": [[0, -1], [0, 0]], "held": "y", "y": -0.001}], "springs": [[8, -1, 1, 0, 1e5], [8, 1, 1, 0, 1e5]])";
  std::string text = plate(covers, R"(, "toughness": {"mode_1": 10})", 6);
  const std::string outline = "[0, -1, 1], [1, -1, 1], [1, 1, 1], [0, 1, 1]";
  text.replace(text.find(outline), outline.size(), "[0, -1, 1], [8, -1, 1], [8, 1, 1], [0, 1, 1], [0, 0, 1]");
  const std::string file = file_of("growth", text);
  const std::string out = fresh_folder("sif_growth_out") + "/out";
  const ProgramRun run = run_keyblock({"run", file, "-o", out});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  const formats::CsvTable tips = formats::read_csv(formats::load(out + "/tips.csv"));
  const formats::CsvTable history = formats::read_csv(formats::load(out + "/history.csv"));
  const auto column = [](const formats::CsvTable& table, const std::string& name) {
    for (std::size_t c = 0; c < table.header.size(); ++c)
      if (table.header[c].starts_with(name)) return c;
    ADD_FAILURE() << name;
    return std::size_t{0};
  };
  const auto number = [](const formats::CsvTable& table, std::size_t row, std::size_t c) {
    return std::stod(table.rows[row].cells[c]);
  };
  ASSERT_EQ(tips.rows.size(), 6U);
  double released = 0, energy_first = 0, energy_last = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const double factor = number(tips, i, column(tips, "load_factor"));
    // History has a row for the initial state.
    const double reaction = number(history, i + 1, column(history, "reaction1_y")) / factor;
    const double energy = reaction * 0.001;  // two arms, half each
    const double j = number(tips, i, column(tips, "J [")) / (factor * factor);
    if (i == 0) energy_first = energy;
    if (i > 0) {
      const double before = number(tips, i - 1, column(tips, "load_factor"));
      released += 0.1 * (j + number(tips, i - 1, column(tips, "J [")) / (before * before));
    }
    energy_last = energy;
    EXPECT_NEAR(number(tips, i, column(tips, "K_eq")), 10, 1e-6);
    EXPECT_NEAR(number(tips, i, column(tips, "y [L]")), 0, 0.01);  // straight by symmetry
  }
  EXPECT_NEAR(energy_first - energy_last, released, 0.01 * released);
  EXPECT_TRUE(std::filesystem::exists(out + "/cracks.svg"));
}

TEST(CrackGrowth, a_tip_that_reaches_the_far_side_ends_the_run) {
  const std::string covers = R"("mesh": {"side": 0.1, "angle": 10}, "cracks": [{"along": [[0, 0], [0.7, 0]]}],
     "growth": {"increment": 0.1}, )";
  const std::string file = file_of("through", plate(covers + kPulled, R"(, "toughness": {"mode_1": 10})", 9));
  const std::string out = fresh_folder("sif_through_out") + "/out";
  const ProgramRun run = run_keyblock({"run", file, "-o", out});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  const Json record = Json::parse(read_text(out + "/run.json"));
  EXPECT_EQ(record.at("outcome").at("steps").get<int>(), 3) << run.messages;
}

TEST(CrackGrowth, needs_statics_toughness_and_elastic_rock) {
  const std::string covers =
      R"("mesh": {"side": 0.2, "tip_side": 0.005}, "cracks": [{"along": [[0, 0], [0.5, 0]]}],
         "growth": {"increment": 0.1}, )";
  const ProgramRun soft = run_keyblock({"sif", file_of("sound", plate(covers + kPulled))});
  EXPECT_EQ(soft.exit_code, 0) << soft.messages;  // sif takes the cracks as they are
  const std::string out = fresh_folder("sif_needs_out") + "/out";
  const ProgramRun no_toughness = run_keyblock({"run", file_of("needs", plate(covers + kPulled)), "-o", out});
  EXPECT_EQ(no_toughness.exit_code, 3);
  EXPECT_NE(no_toughness.messages.find("expected a toughness"), std::string::npos) << no_toughness.messages;
  const std::string scaled =
      R"("mesh": {"side": 0.2, "tip_side": 0.005}, "cracks": [{"along": [[0, 0], [0.5, 0]]}],
         "growth": {"increment": 0.1, "loads": "scaled"}, )";
  const ProgramRun in_time =
      run_keyblock({"run", file_of("time", plate(scaled + kPulled, R"(, "toughness": {"mode_1": 10})")), "--set",
                    "motion=dynamic", "-o", out});
  EXPECT_EQ(in_time.exit_code, 3);
  EXPECT_NE(in_time.messages.find("expected statics for crack growth under scaled loads"), std::string::npos)
      << in_time.messages;
}

}  // namespace
}  // namespace keyblock::sif_command_test
