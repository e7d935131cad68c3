// The program from the command line: help texts, exit codes, the place of each output, and files of others that stay
// untouched.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>

#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::commands_test {
namespace {

using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;

const std::string kCases = KEYBLOCK_SOURCE_DIR "/legacy_cases/";
const std::string kFall = kCases + "free_fall/released";
const std::string kSlide = kCases + "sliding_block/a30_p20/a30_p20";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::vector<double> last_row(const std::string& table) {
  const std::string row = table.substr(table.rfind('\n', table.size() - 2) + 1);
  std::vector<double> values;
  for (std::size_t at = 0; at < row.size(); at = row.find_first_of(",\n", at) + 1)
    values.push_back(std::stod(row.substr(at)));
  return values;
}

}  // namespace

TEST(Commands, every_command_explains_itself) {
  const ProgramRun help = run_keyblock({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* command : {"check", "cut", "joints", "run", "fos", "compare", "tradeoff", "sweep", "batch",
                              "convert", "element", "fit", "formats", "info"}) {
    EXPECT_TRUE(contains(help.output, command)) << command;
    const ProgramRun own = run_keyblock({command, "--help"});
    EXPECT_EQ(own.exit_code, 0) << command;
    EXPECT_TRUE(contains(own.output, "Usage: keyblock " + std::string(command))) << own.output;
  }
}

TEST(Commands, wrong_usage_is_exit_2) {
  const ProgramRun fly = run_keyblock({"fly"});
  EXPECT_EQ(fly.exit_code, 2);
  EXPECT_TRUE(contains(fly.messages, "there is no command \"fly\", only new, check, cut, joints,")) << fly.messages;
  EXPECT_EQ(run_keyblock({"run"}).exit_code, 2);
  const std::string out = fresh_folder("usage") + "/out";
  for (const char* set : {"no_such=1", "steps=0", "steps", "time_step=nan"}) {
    const ProgramRun run = run_keyblock({"run", kSlide + ".geo", kSlide + ".ana", "-o", out, "--set", set});
    EXPECT_EQ(run.exit_code, 2) << set;
    EXPECT_FALSE(std::filesystem::exists(out)) << set;
  }
}

TEST(Commands, settings_are_listed_with_what_they_may_be_and_who_reads_them) {
  const ProgramRun run = run_keyblock({"run", "--settings"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(contains(run.output, "one of constant, shi, error")) << run.output;
  EXPECT_TRUE(contains(run.output, "a number from 0 to 1"));
  EXPECT_TRUE(contains(run.output, "read by"));
}

// The earlier results stay.
TEST(Commands, settings_that_do_not_go_together_are_exit_2_before_anything_is_written) {
  const std::string out = fresh_folder("together") + "/out";
  const std::vector<std::string> run{"run", kSlide + ".geo", kSlide + ".ana", "-o", out, "--force", "--set", "steps=2"};
  ASSERT_EQ(run_keyblock(run).exit_code, 0);
  const std::string record = read_text(out + "/run.json");
  for (const std::vector<std::string>& sets :
       {std::vector<std::string>{"--profile", "legacy", "--set", "step_control=error"},
        {"--profile", "standard", "--set", "motion=static", "--set", "load_steps=0"},
        {"--profile", "standard", "--set", "impact=springs", "--set", "enforcement=lagrange"}}) {
    std::vector<std::string> wrong = run;
    wrong.insert(wrong.end(), sets.begin(), sets.end());
    EXPECT_EQ(run_keyblock(wrong).exit_code, 2) << sets.back();
    EXPECT_EQ(read_text(out + "/run.json"), record);
  }
}

TEST(Commands, a_picture_of_several_cases_is_refused_before_any_is_run) {
  const ProgramRun run = run_keyblock(
      {"compare", kCases + "free_fall", kCases + "sliding_block", "--picture", fresh_folder("pictures") + "/all.svg"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(run.output.empty()) << run.output;
}

TEST(Commands, run_writes_record_history_fields_and_picture) {
  const std::string out = fresh_folder("run") + "/out";
  const ProgramRun run = run_keyblock({"run", kSlide + ".geo", kSlide + ".ana", "--profile", "standard", "-o", out,
                                       "--trace", "--json", "--set", "steps=40", "--record-every", "20"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  const auto record = nlohmann::json::parse(read_text(out + "/run.json"));
  EXPECT_EQ(record, nlohmann::json::parse(run.output));
  EXPECT_EQ(record["outcome"]["end"], "finished");
  EXPECT_EQ(record["settings"]["steps"], 40);
  EXPECT_EQ(record["inputs"].size(), 2U);
  EXPECT_EQ(record["inputs"][0]["sha256"].get<std::string>().size(), 64U);
  EXPECT_EQ(record["counts"]["blocks"], 2);
  const auto steps = formats::read_csv(formats::load(out + "/" + record["steps"]["table"].get<std::string>()));
  EXPECT_EQ(steps.rows.size(), 40U);
  EXPECT_EQ(steps.header, record["steps"]["columns"].get<std::vector<std::string>>());
  EXPECT_FALSE(record["steps"].contains("rows")) << "run.json stays small";
  const auto history = formats::read_csv(formats::load(out + "/history.csv"));
  EXPECT_EQ(history.rows.size(), 41U);
  EXPECT_EQ(history.header[1], "time [T]");
  EXPECT_EQ(formats::read_csv(formats::load(out + "/steps.csv")).rows.size(), 40U);
  EXPECT_EQ(formats::read_csv(formats::load(out + "/blocks.csv")).rows.size(), 3 * 2U);
  const std::string fields = read_text(out + "/fields.pvd");
  for (const char* frame : {"frames/00000000.vtu", "frames/00000020.vtu", "frames/00000040.vtu"}) {
    EXPECT_TRUE(contains(fields, frame));
    EXPECT_TRUE(std::filesystem::exists(out + "/" + frame)) << frame;
  }
  EXPECT_TRUE(contains(fields, R"(timestep="0" part="1" name="contacts")")) << "ParaView looks for parts there alone";
  EXPECT_TRUE(contains(read_text(out + "/picture.svg"), "</svg>"));
  EXPECT_TRUE(contains(read_text(out + "/energy.svg"), "</svg>"));
  EXPECT_TRUE(contains(run.messages, "step 40/40  t = "));
}

// The weight pushes down, the slope back: R/W = 1 − a sin α/g with a = g (sin α − cos α tan φ), at 30 and 20 degrees.
TEST(Commands, the_ledger_names_what_held_blocks_gave_to_momentum) {
  const std::string out = fresh_folder("reaction") + "/out";
  ASSERT_EQ(
      run_keyblock({"run", kSlide + ".geo", kSlide + ".ana", "--profile", "standard", "--set", "steps=40", "-o", out})
          .exit_code,
      0);
  const auto ledger = nlohmann::json::parse(read_text(out + "/run.json"))["ledger"];
  const double alpha = std::numbers::pi / 6;
  const double phi = std::numbers::pi / 9;
  const double share = 1 - (std::sin(alpha) - std::cos(alpha) * std::tan(phi)) * std::sin(alpha);
  const auto& end = ledger["end"];
  EXPECT_NEAR(end["reaction_impulse_y"].get<double>() / -end["impulse_y"].get<double>(), share, 1e-6);
  EXPECT_FALSE(ledger["closure"].contains("linear_momentum"));
}

TEST(Commands, a_long_run_keeps_a_bounded_number_of_rows_and_counts_all_steps) {
  const std::string out = fresh_folder("long") + "/out";
  const int steps = 10'001;  // every third step: 3,333, the last and at most 8 extremes
  ASSERT_EQ(run_keyblock({"run", kSlide + ".geo", kSlide + ".ana", "--profile", "standard", "--set", "basis=rigid",
                          "--set", "time_step=1e-5", "--set", fmt::format("steps={}", steps), "-o", out})
                .exit_code,
            0);
  const auto record = nlohmann::json::parse(read_text(out + "/run.json"));
  for (const char* table : {"steps", "ledger"}) {
    const auto& rows = formats::read_csv(formats::load(out + "/" + record[table]["table"].get<std::string>())).rows;
    EXPECT_EQ(record[table]["kept_every"], 3);
    EXPECT_GE(rows.size(), 3'333U) << table;
    EXPECT_LE(rows.size(), 3'333U + 9U) << table;
    EXPECT_EQ(rows.back().cells[0], fmt::format("{}", steps)) << table;
  }
  EXPECT_LT(read_text(out + "/run.json").size(), 40'000U);
  EXPECT_GE(record["counts"]["passes"], 2 * 3'333) << "of the rows kept alone there would be fewer";
  EXPECT_LE(record["ledger"]["closure"]["energy"].get<double>(), 1e-11);
}

TEST(Commands, a_case_without_geometry_is_named_by_its_file) {
  const std::string folder = fresh_folder("no_geometry");
  support::write_text(folder + "/empty.json", R"({"keyblock": 1})");
  const ProgramRun run = run_keyblock({"run", folder + "/empty.json", "-o", folder + "/out"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_TRUE(contains(run.messages, "empty.json: error: expected a geometry")) << run.messages;
}

TEST(Commands, run_writes_a_ledger_that_closes_and_none_where_it_is_switched_off) {
  const std::string folder = fresh_folder("ledger");
  const std::vector<std::string> run{
      "run", kSlide + ".geo", kSlide + ".ana", "--profile", "standard", "--set", "steps=40", "-o", folder + "/on"};
  ASSERT_EQ(run_keyblock(run).exit_code, 0);
  const auto ledger = nlohmann::json::parse(read_text(folder + "/on/run.json"))["ledger"];
  const auto table = formats::read_csv(formats::load(folder + "/on/" + ledger["table"].get<std::string>()));
  EXPECT_EQ(table.rows.size(), 41U);
  EXPECT_EQ(table.header, ledger["columns"].get<std::vector<std::string>>());
  EXPECT_LE(ledger["closure"]["energy"].get<double>(), 1e-11);
  EXPECT_GT(ledger["end"]["kinetic"].get<double>(), 0);
  std::vector<std::string> without = run;
  without.back() = folder + "/off";
  without.insert(without.end(), {"--set", "ledger=off"});
  ASSERT_EQ(run_keyblock(without).exit_code, 0);
  EXPECT_FALSE(nlohmann::json::parse(read_text(folder + "/off/run.json")).contains("ledger"));
  EXPECT_EQ(read_text(folder + "/off/history.csv"), read_text(folder + "/on/history.csv"));
}

TEST(Commands, the_same_input_gives_the_same_bytes) {
  const std::string folder = fresh_folder("bytes");
  for (const char* name : {"/a", "/b"})
    ASSERT_EQ(run_keyblock({"run", kCases + "reference_traces/grid5/grid5.geo",
                            kCases + "reference_traces/grid5/grid5.ana", "-o", folder + name, "--trace"})
                  .exit_code,
              0);
  for (const char* file : {"/history.csv", "/steps.csv", "/blocks.csv", "/frames/00000030.vtu", "/picture.svg"})
    EXPECT_EQ(read_text(folder + "/a" + file), read_text(folder + "/b" + file)) << file;
}

TEST(Commands, results_of_an_earlier_run_are_not_overwritten_unless_told_to) {
  const std::string out = fresh_folder("again") + "/out";
  const std::vector<std::string> run{"run", kSlide + ".geo", kSlide + ".ana", "-o", out, "--set", "steps=2"};
  ASSERT_EQ(run_keyblock(run).exit_code, 0);
  const std::string record = read_text(out + "/run.json");
  const ProgramRun again = run_keyblock(run);
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_TRUE(contains(again.messages, "--force"));
  EXPECT_EQ(read_text(out + "/run.json"), record);
  std::vector<std::string> forced = run;
  forced.push_back("--force");
  EXPECT_EQ(run_keyblock(forced).exit_code, 0);
}

TEST(Commands, a_run_that_cannot_go_on_says_why_saves_its_state_and_exits_4) {
  const std::string out = fresh_folder("failure") + "/out";
  const ProgramRun run = run_keyblock({"run", kSlide + ".geo", kSlide + ".ana", "-o", out, "--profile", "legacy",
                                       "--set", "allowed_displacement_ratio=1e-9"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_TRUE(contains(run.messages, "move too far")) << run.messages;
  const auto record = nlohmann::json::parse(read_text(out + "/run.json"));
  EXPECT_EQ(record["outcome"]["end"], "failed");
  EXPECT_FALSE(record["outcome"]["reason"].get<std::string>().empty());
  EXPECT_TRUE(contains(read_text(out + "/fields.pvd"), ".vtu"));
}

// Shi's rules throw a dropped block up with 1.4 times its energy before; `standard` at e = 0 does not.
TEST(Commands, a_run_that_makes_energy_ends_with_1_and_the_reason) {
  const std::string out = fresh_folder("doubts") + "/out";
  const std::vector<std::string> old{"run", kCases + "restitution/e_000", "-o", out, "--force", "--profile", "legacy"};
  const ProgramRun run = run_keyblock(old);
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  EXPECT_TRUE(contains(run.messages, "the run finished, but its results are unreliable: energy came from nothing"))
      << run.messages;
  const auto record = nlohmann::json::parse(read_text(out + "/run.json"));
  EXPECT_EQ(record["outcome"]["end"], "finished");
  EXPECT_EQ(record["outcome"]["doubts"].size(), 1u);
  std::vector<std::string> allowed = old;
  allowed.insert(allowed.end(), {"--set", "energy_limit=2"});
  EXPECT_EQ(run_keyblock(allowed).exit_code, 0);
  EXPECT_EQ(
      run_keyblock({"run", kCases + "restitution/e_000", "-o", out, "--profile", "standard", "--force"}).exit_code, 0);
}

TEST(Commands, what_is_balanced_at_the_start_is_said_once) {
  const std::string out = fresh_folder("balanced") + "/out";
  const std::vector<std::string> rest{
      "run", kCases + "block_at_rest/dynamic", "-o", out, "--profile", "standard", "--force", "--verbose"};
  const ProgramRun run = run_keyblock(rest);
  const std::string sentence = "at t = 0 contact forces and strains fit the weight and the first accelerations";
  EXPECT_TRUE(contains(run.messages, "initial state: " + sentence)) << run.messages;
  const auto record = nlohmann::json::parse(read_text(out + "/run.json"));
  EXPECT_TRUE(contains(record["start"]["balanced"], sentence)) << record["start"];
  std::vector<std::string> sudden = rest;
  sudden.insert(sudden.end(), {"--set", "start=sudden"});
  EXPECT_FALSE(contains(run_keyblock(sudden).messages, "initial state: ")) << "nothing is balanced";
}

TEST(Commands, limits_of_penetration_and_crushing_end_a_run_with_1) {
  const std::string out = fresh_folder("limits") + "/out";
  const auto doubt_of = [&](const std::string& place, const std::string& profile, const std::string& set) {
    const ProgramRun run =
        run_keyblock({"run", kCases + place, "-o", out, "--force", "--profile", profile, "--set", set});
    EXPECT_EQ(run.exit_code, 1) << place << ' ' << profile << ' ' << set << '\n' << run.messages;
    const auto record = nlohmann::json::parse(read_text(out + "/run.json"));
    return record["outcome"]["doubts"].empty() ? "" : record["outcome"]["doubts"][0].get<std::string>();
  };
  for (const char* profile : {"legacy", "standard"}) {
    EXPECT_TRUE(contains(doubt_of("block_at_rest/static", profile, "crushing_limit=0.999999999"), "of its area"));
    EXPECT_TRUE(contains(doubt_of("toppling_column/springs_a30_r050", profile, "penetration_limit=1e-9"),
                         "blocks overlapped by"));
  }
}

TEST(Commands, a_run_at_a_limit_of_processor_time_saves_its_state_and_exits_5) {
  const std::string out = fresh_folder("at_limit") + "/out";
  const std::string rest = kCases + "block_at_rest/dynamic/dynamic";
  const ProgramRun run = support::interrupt_keyblock(
      {"run", rest + ".geo", rest + ".ana", "--profile", "standard", "-o", out, "--set", "steps=100000000"},
      out + "/frames/00000000.vtu", SIGXCPU);
  EXPECT_EQ(run.exit_code, 5) << run.messages;
  EXPECT_TRUE(contains(run.messages, "stopped at the limit of processor time after ")) << run.messages;
  EXPECT_TRUE(std::filesystem::exists(out + "/checkpoint.h5"));
}

// 60 MB of numbers that take 240 MB as doubles.
TEST(Commands, a_limit_of_memory_is_named_and_exits_5) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer reserves more than any limit";
#endif
  const std::string folder = fresh_folder("starved");
  std::string text = "0.01 30000000 0 0 0 0 0 0 0\n";
  while (text.size() < 60000000) text += "1 1 1 1 1 1 1 1\n";
  support::write_text(folder + "/large.geo", text);
  const std::string command =
      fmt::format("ulimit -v 250000; '{}' check {}/large.geo 2> {}/messages", KEYBLOCK_PROGRAM, folder, folder);
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 5);
  EXPECT_TRUE(contains(read_text(folder + "/messages"), "not enough memory for this within the limit"));
}

TEST(Commands, an_interrupted_run_saves_its_state_and_exits_130) {
  const std::string out = fresh_folder("stopped") + "/out";
  const std::string rest = kCases + "block_at_rest/dynamic/dynamic";
  const ProgramRun run = support::interrupt_keyblock(
      {"run", rest + ".geo", rest + ".ana", "--profile", "standard", "-o", out, "--set", "steps=100000000"},
      out + "/frames/00000000.vtu");
  EXPECT_EQ(run.exit_code, 130) << run.messages;
  EXPECT_EQ(nlohmann::json::parse(read_text(out + "/run.json"))["outcome"]["end"], "stopped");
}

// A quarter of gravity sideways: the block that falls by g t^2/2 = 19.62 m in 2 s moves by a quarter of it.
TEST(Commands, a_motion_of_the_ground_beside_a_case_moves_its_blocks) {
  const std::string folder = fresh_folder("quake");
  support::write_text(folder + "/quake", "0.02 3\n.25\n.25\n.25\n");
  const ProgramRun run = run_keyblock({"run", kFall + "/released.geo", kFall + "/released.ana", folder + "/quake", "-o",
                                       folder + "/out", "--profile", "standard"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(contains(run.messages, "motion_applied")) << run.messages;
  const auto table = formats::read_csv(formats::load(folder + "/out/history.csv"));
  EXPECT_NEAR(formats::csv_real(table, table.rows.back(), formats::csv_column(table, "dx1 [L]")), 19.62 / 4, 1e-9);
  EXPECT_NEAR(formats::csv_real(table, table.rows.back(), formats::csv_column(table, "dy1 [L]")), -19.62, 1e-9);
}

TEST(Commands, a_case_folder_runs_with_what_its_case_file_sets) {
  const std::string folder = fresh_folder("case_folder");
  const std::string arch = kCases + "masonry_arch/quake_thin_falls";
  const ProgramRun run = run_keyblock({"run", arch, "-o", folder + "/a", "--set", "steps=2"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  const auto settings = nlohmann::json::parse(read_text(folder + "/a/run.json"))["settings"];
  EXPECT_EQ(settings["body_acceleration.x"], 1.549868315056432) << "of case.json";
  EXPECT_EQ(settings["steps"], 2) << "of the command line";
  EXPECT_EQ(run_keyblock({"run", kCases + "masonry_arch", "-o", folder + "/b"}).exit_code, 3) << "several cases";
}

TEST(Commands, a_cut_block_file_runs_like_its_drawing) {
  const std::string folder = fresh_folder("cut");
  const std::string blocks = folder + "/slide.blk";
  const ProgramRun cut = run_keyblock({"cut", kSlide + ".geo", "-o", blocks, "--svg", folder + "/slide.svg"});
  ASSERT_EQ(cut.exit_code, 0) << cut.messages;
  EXPECT_TRUE(contains(read_text(folder + "/slide.svg"), "</svg>"));
  EXPECT_EQ(run_keyblock({"cut", kSlide + ".geo", "-o", blocks}).exit_code, 2) << "it exists";
  ASSERT_EQ(run_keyblock({"run", blocks, kSlide + ".ana", "--profile", "standard", "-o", folder + "/a"}).exit_code, 0);
  ASSERT_EQ(
      run_keyblock({"run", kSlide + ".geo", kSlide + ".ana", "--profile", "standard", "-o", folder + "/b"}).exit_code,
      0);
  EXPECT_EQ(read_text(folder + "/a/history.csv"), read_text(folder + "/b/history.csv"));
}

TEST(Commands, check_names_dialect_evidence_counts_and_plan) {
  const ProgramRun check = run_keyblock({"check", kSlide + ".geo", kSlide + ".ana", "--profile", "legacy"});
  EXPECT_EQ(check.exit_code, 0);
  for (const char* part : {"[ddaml]", "7 lines", "1000 steps", "12 unknowns", "inertia", "contact"})
    EXPECT_TRUE(contains(check.output, part)) << part;
}

TEST(Commands, check_goes_on_after_a_bad_file_and_exits_3) {
  const std::string bad = KEYBLOCK_SOURCE_DIR "/tests/malformed/04_text_in_number_orig.geo";
  const ProgramRun check = run_keyblock({"check", bad, kSlide + ".ana"});
  EXPECT_EQ(check.exit_code, 3);
  EXPECT_TRUE(check.messages.starts_with(bad + ":15:1: error: expected")) << check.messages;
  EXPECT_FALSE(contains(check.output, "error")) << check.output;
  EXPECT_TRUE(contains(check.output, "1000 steps"));
}

TEST(Commands, compare_exits_1_when_a_value_is_missed) {
  const std::string folder = fresh_folder("missed") + "/released";
  std::filesystem::copy(kFall, folder);
  EXPECT_EQ(run_keyblock({"compare", folder}).exit_code, 0);
  const std::string table = read_text(folder + "/expected.csv");
  support::write_text(folder + "/expected.csv", table + "area,2,1,3.5,0.1,a wrong value,this test\n");
  const ProgramRun missed = run_keyblock({"compare", folder});
  EXPECT_EQ(missed.exit_code, 1);
  EXPECT_TRUE(contains(missed.output, "MISSED"));
}

// The first byte shows the kind of a file; two gigabytes of a disk image must not be read.
TEST(Commands, a_long_file_that_is_no_text_is_refused_by_its_beginning) {
  const std::string file = fresh_folder("sparse") + "/disk.img";
  support::write_text(file, "");
  std::filesystem::resize_file(file, 2'000'000'000);
  const ProgramRun check = run_keyblock({"check", file});
  EXPECT_EQ(check.exit_code, 3);
  EXPECT_TRUE(contains(
      check.messages,
      file + ":1:1: error: expected a case file or a DDA geometry, block or analysis file, found a binary file"))
      << check.messages;
  EXPECT_LT(check.peak_megabytes, 1000);
}

// The least number there is: history.csv is written, and the picture of its curves must not end the program.
TEST(Commands, a_run_of_steps_as_short_as_numbers_go_has_its_picture) {
  const std::string folder = fresh_folder("denormal") + "/out";
  const std::string rests = kCases + "sliding_block/a30_p35/a30_p35";
  const ProgramRun run = run_keyblock({"run", rests + ".geo", rests + ".ana", "-o", folder, "--set", "steps=10",
                                       "--set", "motion=static", "--set", "time_step=5e-324"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(contains(read_text(folder + "/picture.svg"), "</svg>")) << run.messages;
  EXPECT_TRUE(std::filesystem::exists(folder + "/run.json"));
}

// Under 1e15 N a block reaches the roof, 49 m above it, in one step. It stops there, and the step is told.
TEST(Commands, a_step_that_throws_a_block_against_a_far_roof_is_told) {
  const std::string folder = fresh_folder("thrown");
  support::write_text(folder + "/thrown.json", R"({"keyblock": 1,
    "blocks": {"blocks": [{"outer": [[0, -1, 1], [10, -1, 1], [10, 0, 1], [0, 0, 1]]},
                          {"outer": [[1, 0, 1], [2, 0, 1], [2, 1, 1], [1, 1, 1]]},
                          {"outer": [[0, 50, 1], [10, 50, 1], [10, 51, 1], [0, 51, 1]]}],
               "fixed_points": [[1, -0.5, 1], [9, -0.5, 1], [1, 50.5, 3], [9, 50.5, 3]],
               "loading_points": [[1.5, 0.5, 2]]},
    "analysis": {"step_count": 3, "time_step": 0.001, "velocity_carry_over": 1, "allowed_displacement_ratio": 0.01,
                 "joint_materials": [{"friction_angle_deg": 30}], "point_loads": [[[0, 0, 1e15]]],
                 "block_materials": [{"density": 2500, "unit_weight": 24525, "youngs_modulus": 5e18,
                                      "poissons_ratio": 0.25}]}})");
  const ProgramRun run = run_keyblock({"run", folder + "/thrown.json", "-o", folder + "/out"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(contains(run.messages, "largest   block 2 near (1, 0): 49\n")) << run.messages;
  EXPECT_TRUE(contains(run.messages, "it may have passed through others")) << run.messages;
  // Rigid blocks have nothing that gives way: the strike makes energy, and that is told.
  const ProgramRun rigid =
      run_keyblock({"run", folder + "/thrown.json", "-o", folder + "/rigid", "--set", "basis=rigid"});
  EXPECT_EQ(rigid.exit_code, 1) << rigid.messages;
}

TEST(Commands, a_missing_file_is_exit_3) {
  const ProgramRun run = run_keyblock({"run", "no_such.geo", kSlide + ".ana", "-o", fresh_folder("none") + "/out"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_TRUE(contains(run.messages, "no_such.geo: error: expected")) << run.messages;
}

TEST(Commands, compare_goes_on_after_a_case_that_cannot_be_read) {
  const std::string folder = fresh_folder("bad_setting") + "/released";
  std::filesystem::copy(kFall, folder);
  support::write_text(folder + "/case.json", R"({"set": {"both": {"time_stop": "1"}}})");
  const ProgramRun both = run_keyblock({"compare", folder, kFall});
  EXPECT_EQ(both.exit_code, 1);
  EXPECT_TRUE(contains(both.messages, "case.json: error: key set.both.time_stop: there is no setting"))
      << both.messages;
  EXPECT_TRUE(contains(both.output, "speed of block 2")) << both.output;
}

TEST(Commands, compare_leaves_slow_cases_out_unless_all_are_asked_for) {
  const std::string folder = fresh_folder("slow") + "/released";
  std::filesystem::copy(kFall, folder);
  support::write_text(folder + "/case.json", R"({"slow": true})");
  const ProgramRun quick = run_keyblock({"compare", folder, kCases + "free_fall/spinning"});
  EXPECT_EQ(quick.exit_code, 0);
  EXPECT_TRUE(contains(quick.messages, "1 case, 0 traces, 0 missed; 1 slow case left out")) << quick.messages;
  EXPECT_EQ(run_keyblock({"compare", folder}).exit_code, 0) << "a slow case named alone is run";
  const ProgramRun all = run_keyblock({"compare", "--all", folder});
  EXPECT_EQ(all.exit_code, 0);
  EXPECT_TRUE(contains(all.messages, "1 case, 0 traces, 0 missed")) << all.messages;
}

TEST(Commands, compare_shows_both_profiles_or_the_one_asked_for) {
  const ProgramRun both = run_keyblock({"compare", kFall});
  EXPECT_TRUE(contains(both.output, "error legacy") && contains(both.output, "error standard")) << both.output;
  const ProgramRun one = run_keyblock({"compare", "--profile", "standard", kFall});
  EXPECT_EQ(one.exit_code, 0);
  EXPECT_FALSE(contains(one.output, "error legacy")) << one.output;
}

// Cook's membrane: 23.966 (legacy_cases/cook_membrane).
TEST(Commands, bodies_on_covers_are_checked_solved_and_drawn) {
  const std::string file = kCases + "cook_membrane/coarse/coarse.json";
  const ProgramRun check = run_keyblock({"check", file});
  EXPECT_EQ(check.exit_code, 0) << check.messages;
  EXPECT_TRUE(contains(check.output, "unknowns: derived functions, ")) << check.output;
  EXPECT_TRUE(contains(check.output, "load steps are linear static solutions of 1 body")) << check.output;
  const std::string out = fresh_folder("covers") + "/out";
  const ProgramRun run = run_keyblock({"run", file, "-o", out});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  for (const char* name :
       {"run.json", "picture.svg", "history.csv", "field.svg", "points.csv", "fields.pvd", "frames/00000001.vtu"})
    EXPECT_TRUE(std::filesystem::exists(out + "/" + name)) << name;
  const auto record = nlohmann::json::parse(read_text(out + "/run.json"));
  EXPECT_LT(record["forces"]["unbalanced"].get<double>(), 1e-9);
  EXPECT_LT(record["counts"]["greatest_residual"].get<double>(), 1e-9);
  EXPECT_NEAR(record["forces"]["supports"][0]["y"].get<double>(), -1, 1e-9);
  EXPECT_NEAR(last_row(read_text(out + "/history.csv")).at(5), 23.966, 0.024);
  EXPECT_EQ(run_keyblock({"run", file, "-o", out, "--force", "--set", "mesh.side=wide"}).exit_code, 2);
  EXPECT_EQ(
      run_keyblock({"run", file, "-o", out, "--force", "--set", "functions=linear", "--set", "mesh.side=8"}).exit_code,
      0);
}

// The free end of a beam carries no normal stress, and the load 1 as shear: 1.5 in the middle of its height.
TEST(Commands, steps_of_bodies_on_covers_leave_stress_at_points_and_its_picture) {
  const std::string file = kCases + "sudden_load_on_covers/damped/damped.json";
  const std::string out = fresh_folder("cover_steps") + "/out";
  const ProgramRun run = run_keyblock({"run", file, "-o", out});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  const std::string field = read_text(out + "/field.svg");
  EXPECT_TRUE(contains(field, "displacement × "));
  EXPECT_TRUE(contains(field, "tension positive"));
  const std::vector<double> values = last_row(read_text(out + "/points.csv"));
  ASSERT_EQ(values.size(), 11U);
  EXPECT_NEAR(values[7], 0, 0.6) << "1 % of the greatest, at the root";
  EXPECT_NEAR(values[9], 1.5, 0.3);
}

TEST(Commands, a_body_on_covers_that_can_move_is_exit_4) {
  std::string text = read_text(kCases + "cook_membrane/coarse/coarse.json");
  const std::string held = "{\"along\": [[0, 44], [0, 0]]}";
  ASSERT_TRUE(contains(text, held));
  text.replace(text.find(held), held.size(), "{\"along\": [[0, 44], [0, 0]], \"held\": \"normal\"}");
  const std::string folder = fresh_folder("loose");
  support::write_text(folder + "/loose.json", text);
  const ProgramRun run = run_keyblock({"run", folder + "/loose.json", "-o", folder + "/out"});
  EXPECT_EQ(run.exit_code, 4) << run.messages;
  EXPECT_TRUE(contains(run.messages, "body 1, about (24, 30), can move along (0, 1): it has no support"))
      << run.messages;
}

}  // namespace keyblock::commands_test
