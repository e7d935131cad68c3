// `sweep --over`, its shards, and `run --at` from the command line.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/bytes/sha256.hpp"
#include "tests/app/value_sweeps.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::value_sweep_test {
namespace {

namespace fs = std::filesystem;
using support::contains;
using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using support::write_text;

}  // namespace
TEST(ValueSweep, a_grid_is_one_table_whatever_the_shards) {
  const std::string folder = fresh_folder("value_sweep_shards");
  const std::string file = slope_in(folder);
  const ProgramRun whole = run_keyblock(sweep_of(file, folder + "/whole"));
  ASSERT_EQ(whole.exit_code, 0) << whole.messages;
  const std::string table = read_text(folder + "/whole/table.csv");
  EXPECT_EQ(table, whole.output);
  EXPECT_EQ(std::ranges::count(table, '\n'), 9);
  EXPECT_TRUE(
      table.starts_with("/analysis/joint_materials/0/friction_angle_deg,time_step,verdict,doubt,warnings,displacement,"
                        "point1.dx,ledger.friction,/counts/blocks,job\n10,10 ms,finished,,,1.7"))
      << table;
  EXPECT_TRUE(fs::exists(folder + "/whole/sweep.svg"));
  const Words shards = sweep_of(file, folder + "/shards");
  EXPECT_EQ(run_keyblock(shards + Words{"--shard", "2/2"}).exit_code, 0);
  EXPECT_EQ(run_keyblock(shards + Words{"--merge"}).exit_code, 2) << "not all done";
  EXPECT_EQ(run_keyblock(shards + Words{"--shard", "1/2"}).exit_code, 0);
  EXPECT_EQ(run_keyblock(shards + Words{"--merge"}).exit_code, 0);
  EXPECT_EQ(read_text(folder + "/shards/table.csv"), table);
}

TEST(ValueSweep, times_and_factors_of_safety_have_no_tails_of_round_off) {
  const std::string folder = fresh_folder("value_sweep_tails");
  const ProgramRun run = run_keyblock({"sweep", slope_in(folder), "--over", "time_step=3 ms,0.7 ms", "--over",
                                       "steps=77", "--out", "time,fos", "-o", folder + "/out"});
  EXPECT_TRUE(contains(run.output, "\n3 ms,77,finished,,,0.231,0.624,")) << run.output;
  EXPECT_TRUE(contains(run.output, "\n0.7 ms,77,finished,,,0.0539,0.624,")) << run.output;
  for (const auto& job : fs::directory_iterator(folder + "/out/jobs")) {
    std::istringstream table(read_text(job.path() / "run/history.csv"));
    std::string line;
    for (std::getline(table, line); std::getline(table, line);) {
      const std::size_t begin = line.find(',') + 1;
      EXPECT_LE(line.find(',', begin) - begin, std::string_view("0.0539").size()) << line;
    }
  }
}

TEST(ValueSweep, files_of_the_user_are_neither_removed_nor_replaced) {
  const std::string folder = fresh_folder("value_sweep_foreign");
  const std::string file = slope_in(folder);
  const Words words{"sweep", file, "--over", "steps=5,6", "-o", folder + "/out"};
  fs::create_directories(folder + "/out/jobs");
  write_text(folder + "/out/jobs/mine", "x");
  write_text(folder + "/out/journal-2024.jsonl", "{}\n");
  const ProgramRun foreign = run_keyblock(words + Words{"--force"});
  EXPECT_EQ(foreign.exit_code, 2) << foreign.messages;
  EXPECT_TRUE(contains(foreign.messages, "is no journal of a sweep")) << foreign.messages;
  EXPECT_TRUE(fs::exists(folder + "/out/journal-2024.jsonl"));

  fs::remove(folder + "/out/journal-2024.jsonl");
  write_text(folder + "/out/times.csv", "mine");
  EXPECT_EQ(run_keyblock(words + Words{"--shard", "1/2"}).exit_code, 2);
  EXPECT_EQ(read_text(folder + "/out/times.csv"), "mine");

  fs::remove_all(folder + "/out");
  ASSERT_EQ(run_keyblock(words).exit_code, 0);
  write_text(folder + "/out/jobs/mine", "x");
  EXPECT_EQ(run_keyblock(words + Words{"--force"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder + "/out/jobs/mine")) << "a sweep removes its own jobs alone";
}

TEST(ValueSweep, a_factor_that_is_only_a_bound_is_no_finished_row) {
  const std::string folder = fresh_folder("value_sweep_bound");
  const std::string file = slope_in(folder);
  const ProgramRun made = run_keyblock({"sweep", file, "--over", "/analysis/joint_materials/0/friction_angle_deg=89.9",
                                        "--out", "displacement,fos", "-o", folder + "/out"});
  EXPECT_EQ(made.exit_code, 1) << made.output;
  EXPECT_TRUE(contains(made.output, ",stands,F = 16: stands,")) << made.output;
}

TEST(ValueSweep, a_longer_grid_computes_what_is_missing) {
  const std::string folder = fresh_folder("value_sweep_longer");
  const std::string file = slope_in(folder);
  const auto of = [&](const std::string& values) {
    return Words{"sweep", file, "--over", "steps=" + values, "-o", folder + "/out"};
  };
  ASSERT_EQ(run_keyblock(of("10,20")).exit_code, 0);
  const std::string first = read_text(folder + "/out/journal.jsonl");
  EXPECT_EQ(run_keyblock(of("10,20")).exit_code, 2) << "neither --resume nor --force";
  ASSERT_EQ(run_keyblock(of("10,20,30") + Words{"--resume"}).exit_code, 0);
  const std::string second = read_text(folder + "/out/journal.jsonl");
  EXPECT_TRUE(second.starts_with(first)) << "rows of before are not computed again";
  EXPECT_EQ(std::ranges::count(second, '\n'), 4);
  EXPECT_EQ(run_keyblock(of("10") + Words{"--resume", "--out", "speed"}).exit_code, 2) << "another sweep";
}

TEST(ValueSweep, a_row_in_trouble_is_a_row) {
  const std::string folder = fresh_folder("value_sweep_trouble");
  const std::string file = slope_in(folder);
  const ProgramRun run =
      run_keyblock({"sweep", file, "--over", "/analysis/joint_materials/0/friction_angle_deg=20,95,steep,30", "--out",
                    "displacement,state", "-o", folder + "/out"});
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  EXPECT_TRUE(contains(run.output, "\n95,error,")) << run.output;
  EXPECT_TRUE(contains(run.output, "\nsteep,error,")) << run.output;
  EXPECT_TRUE(contains(run.output, "\n20,finished,,,0.9")) << run.output;
}

TEST(ValueSweep, a_row_without_an_output_is_a_row_with_its_reason) {
  const std::string folder = fresh_folder("value_sweep_lacking");
  const ProgramRun run = run_keyblock({"sweep", slope_in(folder), "--over", "ledger=off,on", "--over", "steps=2",
                                       "--out", "ledger.friction,displacement", "-o", folder + "/out"});
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  EXPECT_TRUE(contains(run.output,
                       "\noff,2,error,\"expected a result of the run, which has no ledger.csv, found "
                       "ledger.friction\",,,0.00"))
      << run.output;
  EXPECT_TRUE(contains(run.output, "\non,2,finished,,,")) << run.output;
}

TEST(ValueSweep, an_output_that_no_row_has_is_refused_as_soon_as_it_is_known) {
  const std::string folder = fresh_folder("value_sweep_typo");
  const Words sweep{"sweep", slope_in(folder), "--over", "steps=2,3", "--history", "crest=block:2",
                    "-o",    folder + "/out",  "--out"};
  for (const auto& [name, expected] : {std::pair{"ledger.frction", "expected a column of ledger.csv: step, time, "},
                                       {"point1.dz", "expected a column of points.csv: "},
                                       {"crset.dx", "expected a quantity of the history crest, found crset.dx"}}) {
    const ProgramRun early = run_keyblock(sweep + Words{name});
    EXPECT_EQ(early.exit_code, 2) << name;
    EXPECT_TRUE(contains(early.messages, expected)) << early.messages;
    EXPECT_FALSE(fs::exists(folder + "/out")) << name;
  }
  const ProgramRun late = run_keyblock(sweep + Words{"displacement,point7.dx"});
  EXPECT_EQ(late.exit_code, 2) << late.messages;
  EXPECT_TRUE(contains(late.messages,
                       "error: --out: expected the number of a measured point, found point7.dx, in every "
                       "run"))
      << late.messages;
  EXPECT_FALSE(fs::exists(folder + "/out/table.csv"));
}

TEST(ValueSweep, a_changed_file_that_a_setting_names_computes_its_rows_again) {
  const std::string folder = fresh_folder("value_sweep_named_file");
  const std::string file = slope_in(folder);
  for (const char* name : {"/1.csv", "/2.csv"}) write_text(folder + name, "time,ax,ay\n0,0,0\n1,1,0\n");
  const Words sweep{"sweep",    file,     "--set",
                    "steps=2",  "-o",     folder + "/out",
                    "--resume", "--over", "body_acceleration_file=" + folder + "/1.csv," + folder + "/2.csv"};
  const auto lines = [&] {
    EXPECT_EQ(run_keyblock(sweep).exit_code, 0);
    return std::ranges::count(read_text(folder + "/out/journal.jsonl"), '\n');
  };
  EXPECT_EQ(lines(), 3);
  EXPECT_EQ(lines(), 3);
  write_text(folder + "/2.csv", "time,ax,ay\n0,5,0\n1,5,0\n");
  EXPECT_EQ(lines(), 4);
  const auto record = nlohmann::json::parse(read_text(folder + "/out/sweep.json"));
  EXPECT_EQ(record["inputs"].back()["sha256"], sha256(read_text(folder + "/2.csv")));

  const Words run{"run", file,           "--set", "steps=2", "--set", "body_acceleration_file=" + folder + "/1.csv",
                  "-o",  folder + "/run"};
  ASSERT_EQ(run_keyblock(run).exit_code, 0);
  const auto input = nlohmann::json::parse(read_text(folder + "/run/run.json"))["inputs"].back();
  EXPECT_EQ(input["sha256"], sha256(read_text(folder + "/1.csv")));
  EXPECT_EQ(input["setting"], "body_acceleration_file");
  ASSERT_EQ(run_keyblock({"report", folder + "/run", "-o", folder + "/report.html"}).exit_code, 0);
  EXPECT_FALSE(contains(read_text(folder + "/report.html"), "Not listed")) << "materials are those of the case alone";
}

// A row that could not be written is no result: the sweep ends, and computes it when it is resumed.
TEST(ValueSweep, files_that_may_not_grow_end_the_sweep_with_exit_4) {
  const std::string folder = fresh_folder("value_sweep_full");
  const std::string words = " --over steps=20,1000 -o " + folder + "/out";
  const ProgramRun run = support::run_script("ulimit -f 40; exec $K sweep " + slope_in(folder) + words);
  EXPECT_EQ(run.exit_code, 4) << run.messages;
  EXPECT_TRUE(contains(run.messages, "error: cannot write ")) << run.messages;
  const ProgramRun resumed = support::run_script("exec $K sweep " + folder + "/block.json --resume" + words);
  EXPECT_EQ(resumed.exit_code, 0) << resumed.messages;
  EXPECT_TRUE(contains(resumed.output, "\n20,finished,,,")) << resumed.output;
  EXPECT_TRUE(contains(resumed.output, "\n1000,finished,,")) << resumed.output;
}

// This run has no equilibrium, and its file has such a name.
TEST(ValueSweep, the_words_of_a_message_end_no_batch) {
  const std::string folder = fresh_folder("batch_words");
  fs::create_directories(folder + "/archive");
  const std::string file = folder + "/archive/cannot write.json";
  ASSERT_EQ(run_keyblock({"new", "block", "--strict-json", "-o", file}).exit_code, 0);
  auto json = nlohmann::ordered_json::parse(read_text(file));
  json["run"]["set"]["motion"] = "static";
  write_text(file, json.dump());
  const ProgramRun failed =
      run_keyblock({"batch", folder + "/archive", "--run", "--profile", "standard", "-o", folder + "/out"});
  EXPECT_EQ(failed.exit_code, 1) << failed.messages;
  EXPECT_TRUE(contains(read_text(folder + "/out/catalogue.csv"), "exit code 4")) << failed.messages;
}

TEST(ValueSweep, a_search_without_an_answer_is_a_row) {
  const std::string folder = fresh_folder("value_sweep_loose"), file = folder + "/slope.json";
  run_keyblock({"new", "slope", "--strict-json", "-o", file});
  auto json = nlohmann::ordered_json::parse(read_text(file));
  json["drawing"].erase("fixed_lines");
  write_text(file, json.dump());
  const ProgramRun run = run_keyblock({"sweep", file, "--over", "steps=2,3", "--out", "fos", "-o", folder + "/out"});
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  EXPECT_TRUE(contains(run.output, "\n2,error,")) << run.output;
  EXPECT_TRUE(contains(run.output, "nothing fixes the blocks")) << run.output;
}

TEST(ValueSweep, wrong_usage_is_found_before_any_job) {
  const std::string folder = fresh_folder("value_sweep_usage");
  const std::string file = slope_in(folder);
  for (const Words& wrong :
       {Words{"--over", "/no/such=1"}, Words{"--over", "no_setting=1"}, Words{"--over", "steps=1", "--out", "colour"},
        Words{"--over", "steps=normal(1,1)"}, Words{"--over", "steps=1", "--shard", "3/2"}, Words{"--set", "steps=1"},
        Words{"--over", "joints:/seed=1"}, Words{"--random", "3"}}) {
    const ProgramRun run = run_keyblock(Words{"sweep", file, "-o", folder + "/out"} + wrong);
    EXPECT_EQ(run.exit_code, 2) << wrong[1] << run.messages;
    EXPECT_FALSE(fs::exists(folder + "/out"));
  }
}

TEST(ValueSweep, random_joints_are_drawn_anew_for_each_row) {
  const std::string folder = fresh_folder("value_sweep_joints");
  write_text(folder + "/joints.json",
             R"({"slope": {"height": 6, "angle": 60, "toe": 3, "crest": 6, "base": 2}, "fixed": [[-3, -1.9, 12, -1.9]],
                 "sets": [{"dip": 35, "spacing": 2, "trace": 100, "scatter": 0.2, "joint": 1}], "seed": 1})");
  write_text(folder + "/face.json",
             R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"}, "analysis": {"step_count": 5,
                 "time_step": "1 ms", "block_materials": [{"like": "limestone"}],
                 "joint_materials": [{"name": "bedding", "friction_angle_deg": 40}]}})");
  const ProgramRun run = run_keyblock({"sweep", folder + "/face.json", "--joints", folder + "/joints.json", "--over",
                                       "joints:/sets/0/dip=normal(35,3)", "--over", "joints:/seed=1,2", "--over",
                                       "/analysis/joint_materials/bedding/friction_angle_deg=uniform(30,40)",
                                       "--random", "4", "--out", "blocks,displacement", "-o", folder + "/out"});
  EXPECT_LE(run.exit_code, 1) << run.messages;
  EXPECT_EQ(std::ranges::count(run.output, '\n'), 5) << run.output;
  EXPECT_FALSE(contains(run.output, ",error,")) << run.output;
}

// Values of several units have no axis of numbers: their places have words.
TEST(ValueSweep, a_list_of_several_units_has_none_in_table_and_picture) {
  const std::string folder = fresh_folder("value_sweep_units");
  const std::string file = slope_in(folder);
  ASSERT_EQ(run_keyblock({"sweep", file, "--over", "time_step=1 ms, 0.002 s, 3 ms", "--set", "steps=2", "--out",
                          "displacement", "-o", folder + "/out"})
                .exit_code,
            0);
  EXPECT_TRUE(contains(read_text(folder + "/out/columns.csv"), "\ntime_step,,step size\n"));
  EXPECT_TRUE(contains(read_text(folder + "/out/sweep.svg"), "step size (1: 1 ms, 2: 0.002 s, 3: 3 ms)"));
}

TEST(ValueSweep, columns_have_units_and_words) {
  const std::string folder = fresh_folder("value_sweep_columns");
  const std::string file = slope_in(folder);
  ASSERT_EQ(run_keyblock(sweep_of(file, folder + "/out")).exit_code, 0);
  EXPECT_EQ(read_text(folder + "/out/columns.csv"),
            "column,unit,meaning\n"
            "/analysis/joint_materials/0/friction_angle_deg,deg,friction angle of joint material 1\n"
            "time_step,ms,step size\n"
            "verdict,,end of the run\n"
            "doubt,,reason for the verdict\nwarnings,,codes of warnings; keyblock explain CODE tells more\n"
            "displacement,m,largest displacement\n"
            "point1.dx,m,measured point 1: displacement x\n"
            "ledger.friction,N·m/m,energy balance: friction\n"
            "/counts/blocks,,\"blocks, counts\"\n"
            "job,,folder of the run in jobs\n");
  const std::string picture = read_text(folder + "/out/sweep.svg");
  EXPECT_TRUE(contains(picture, "friction angle of joint material 1 [deg]"));
  EXPECT_TRUE(contains(picture, "step size [ms]"));  // the unit of the values
  EXPECT_FALSE(contains(picture, "/analysis"));
  const auto record = nlohmann::json::parse(read_text(folder + "/out/sweep.json"));
  EXPECT_EQ(record["made_by"]["command"][1], "sweep");
  EXPECT_EQ(record["inputs"][0]["file"], file);
  EXPECT_EQ(record["output_sha256"]["table.csv"], sha256(read_text(folder + "/out/table.csv")));
}

TEST(ValueSweep, a_table_of_more_runs_stays) {
  const std::string folder = fresh_folder("value_sweep_larger");
  const std::string file = slope_in(folder);
  const auto command = [&](const char* steps) {
    return Words{"sweep", file, "--over", std::string("steps=") + steps, "-o", folder + "/out"};
  };
  ASSERT_EQ(run_keyblock(command("2,3,4")).exit_code, 0);
  const std::string table = read_text(folder + "/out/table.csv");
  for (const char* option : {"--resume", "--merge"}) {
    const ProgramRun smaller = run_keyblock(command("2,3") + Words{option});
    EXPECT_EQ(smaller.exit_code, 2);
    EXPECT_TRUE(
        contains(smaller.messages, "has 1 run that this sweep lacks; give another folder, or --force to replace it"))
        << smaller.messages;
    const ProgramRun other = run_keyblock(command("2,3") + Words{option, "--set", "time_step=1 ms"});
    EXPECT_TRUE(contains(other.messages, "a sweep of another case, output or limit")) << other.messages;
    EXPECT_EQ(read_text(folder + "/out/table.csv"), table);
  }
  EXPECT_EQ(run_keyblock(command("2,3") + Words{"--merge", "--force"}).exit_code, 0);
  EXPECT_EQ(std::ranges::count(read_text(folder + "/out/table.csv"), '\n'), 3);
  EXPECT_EQ(run_keyblock(command("2,3,4,5") + Words{"--resume"}).exit_code, 0);
  EXPECT_EQ(std::ranges::count(read_text(folder + "/out/table.csv"), '\n'), 5);
}

TEST(ValueSweep, whole_numbers_do_not_come_from_distributions) {
  const std::string folder = fresh_folder("value_sweep_whole");
  const Words sweep{"sweep", slope_in(folder), "--random", "4", "-o", folder + "/out", "--over"};
  for (const auto& [key, words] : {std::pair{"steps", "setting steps: expected a whole number of at least 1, found "},
                                   {"/analysis/step_count", "/analysis/step_count: expected a whole number, found "}}) {
    const ProgramRun run = run_keyblock(sweep + Words{key + std::string("=normal(100,10)")});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(contains(run.messages, words)) << run.messages;
    EXPECT_FALSE(fs::exists(folder + "/out"));
  }
}

TEST(ValueSweep, run_at_gives_what_the_changed_file_gives) {
  const std::string folder = fresh_folder("value_sweep_at");
  const std::string file = slope_in(folder);
  const std::string key = "/analysis/joint_materials/0/friction_angle_deg";
  ASSERT_EQ(run_keyblock({"new", "block", "--strict-json", "-o", folder + "/strict.json"}).exit_code, 0);
  auto json = nlohmann::ordered_json::parse(read_text(folder + "/strict.json"));
  json[nlohmann::ordered_json::json_pointer(key)] = 12.5;
  write_text(folder + "/changed.json", json.dump());
  ASSERT_EQ(run_keyblock({"run", folder + "/changed.json", "-o", folder + "/changed"}).exit_code, 0);
  ASSERT_EQ(run_keyblock({"run", file, "--at", key + "=12.5", "-o", folder + "/at"}).exit_code, 0);
  EXPECT_EQ(read_text(folder + "/at/history.csv"), read_text(folder + "/changed/history.csv"));
  const auto record = nlohmann::json::parse(read_text(folder + "/at/run.json"));
  EXPECT_EQ(record["values"][key], 12.5);
  EXPECT_EQ(record["inputs"][0]["file"], file);
  EXPECT_EQ(run_keyblock({"run", file, "--at", key, "-o", folder + "/no"}).exit_code, 2);
  EXPECT_EQ(run_keyblock({"run", file, "--at", "/no/key=1", "-o", folder + "/no"}).exit_code, 2);
  EXPECT_EQ(run_keyblock({"run", file, "--at", "/analysis/no_key=1", "-o", folder + "/no"}).exit_code, 3);
}

TEST(ValueSweep, a_name_with_an_equals_sign_is_addressed) {
  const std::string folder = fresh_folder("value_sweep_equals"), file = folder + "/block.json";
  ASSERT_EQ(run_keyblock({"new", "block", "--strict-json", "-o", file}).exit_code, 0);
  auto json = nlohmann::ordered_json::parse(read_text(file));
  json["analysis"]["joint_materials"][0]["name"] = "c=0";
  write_text(file, json.dump());
  const std::string key = "/analysis/joint_materials/c~20/friction_angle_deg";
  const ProgramRun swept = run_keyblock({"sweep", file, "--over", key + "=10,20", "-o", folder + "/out"});
  EXPECT_EQ(swept.exit_code, 0) << swept.messages;
  EXPECT_TRUE(contains(swept.output, "\n10,finished,,,1.70")) << swept.output;
  write_text(folder + "/rows.json", R"([{"/analysis/joint_materials/c=0/friction_angle_deg": 10}])");
  const ProgramRun rows = run_keyblock({"sweep", file, "--design", folder + "/rows.json", "-o", folder + "/rows"});
  EXPECT_TRUE(contains(rows.output, "\n10,finished,,,1.70")) << rows.output;
  const Words run{"run",         file,    "--at",           key + "=10", "--set",
                  "steps=20000", "--set", "time_step=1e-5", "-o",        folder + "/run"};
  EXPECT_EQ(support::interrupt_keyblock(run, folder + "/run/checkpoint.h5", SIGTERM).exit_code, 130);
  const ProgramRun resumed = run_keyblock({"run", "--resume", folder + "/run"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.messages;
}

}  // namespace keyblock::value_sweep_test
