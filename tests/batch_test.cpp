// A batch from the command line: an archive of many kinds of names is catalogued, killed and resumed, run and compared.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/support/mixed_archive.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sample_covers.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::batch_test {
namespace {

namespace fs = std::filesystem;
using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using support::write_text;

const std::string kCases = KEYBLOCK_SOURCE_DIR "/legacy_cases/";
const std::vector<std::string> kCatalogue{"catalogue.csv", "catalogue.json", "catalogue.html"};

std::map<std::string, std::string> catalogue_in(const fs::path& folder) {
  std::map<std::string, std::string> texts;
  for (const std::string& name : kCatalogue) texts[name] = read_text(folder / name);
  return texts;
}

nlohmann::json jobs_in(const fs::path& folder) {
  return nlohmann::json::parse(read_text(folder / "catalogue.json"))["jobs"];
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Copies the two files of a case.
void copy_case(const std::string& name, const fs::path& folder) {
  fs::create_directories(folder);
  for (const char* ending : {".geo", ".blk", ".ana"})
    if (fs::exists(kCases + name + ending))
      fs::copy_file(kCases + name + ending, folder / (fs::path(name).filename().string() + ending));
}

}  // namespace

TEST(Batch, every_sound_case_of_a_mixed_archive_is_paired_and_every_broken_file_is_told) {
  const fs::path root = fresh_folder("batch_mixed");
  const auto made = support::write_mixed_archive(root / "in", 41, 0.1, 7);
  ASSERT_GE(made.broken.size(), 2U);
  const ProgramRun run = run_keyblock({"batch", root / "in", "--check", "-o", root / "out"});
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  std::set<std::string> failed;
  std::size_t files = 0;
  for (const auto& job : jobs_in(root / "out")) {
    bool is_touched = false;
    for (const auto& file : job["files"]) {
      ++files;
      const std::string path = file["path"];
      is_touched = is_touched || made.broken.contains(path) || made.partners.contains(path);
      if (job["outcome"] == "failed") failed.insert(path);
    }
    if (is_touched || job["outcome"] == "listed") continue;
    EXPECT_EQ(job["files"].size(), 2U) << job;
    EXPECT_NE(job["outcome"], "failed") << job;
  }
  EXPECT_EQ(files, 41U);
  for (const std::string& path : made.broken) EXPECT_TRUE(failed.contains(path)) << path;
}

TEST(Batch, the_catalogue_is_the_same_for_any_number_of_threads) {
  const fs::path root = fresh_folder("batch_threads");
  support::write_mixed_archive(root / "in", 40, 0.05, 3);
  run_keyblock({"batch", root / "in", "--check", "-o", root / "one", "--jobs", "1"});
  run_keyblock({"batch", root / "in", "--check", "-o", root / "four", "--jobs", "4"});
  EXPECT_FALSE(read_text(root / "one" / "catalogue.csv").empty());
  EXPECT_EQ(catalogue_in(root / "one"), catalogue_in(root / "four"));
}

TEST(Batch, killed_in_the_middle_and_resumed_it_gives_the_same_catalogue) {
  const fs::path root = fresh_folder("batch_killed");
  support::write_mixed_archive(root / "in", 40, 0.05, 11);
  const std::vector<std::string> batch{"batch",        root / "in", "--run",  "--profile", "legacy",
                                       "--time-limit", "20",        "--jobs", "2"};
  const auto with = [&](const std::string& out, bool is_resumed) {
    std::vector<std::string> arguments = batch;
    arguments.insert(arguments.end(), {"-o", root / out});
    if (is_resumed) arguments.emplace_back("--resume");
    return arguments;
  };
  run_keyblock(with("whole", false));
  const auto lines = [](const fs::path& journal) { return std::ranges::count(read_text(journal), '\n'); };
  const auto all = lines(root / "whole" / "journal.jsonl");
  const ProgramRun killed = support::kill_keyblock(with("killed", false), root / "killed" / "journal.jsonl", 6);
  EXPECT_EQ(killed.exit_code, 128 + SIGKILL);
  EXPECT_LT(lines(root / "killed" / "journal.jsonl"), all);
  EXPECT_FALSE(fs::exists(root / "killed" / "catalogue.csv"));
  std::ofstream(root / "killed" / "journal.jsonl", std::ios::app) << R"({"row":{"job":"torn)";
  const ProgramRun resumed = run_keyblock(with("killed", true));
  EXPECT_TRUE(contains(resumed.messages, "done before")) << resumed.messages;
  EXPECT_EQ(lines(root / "killed" / "journal.jsonl"), all);
  EXPECT_EQ(catalogue_in(root / "whole"), catalogue_in(root / "killed"));
}

TEST(Batch, a_changed_file_is_done_again_and_nothing_else) {
  const fs::path root = fresh_folder("batch_changed");
  copy_case("sliding_block/a30_p20/a30_p20", root / "in/one");
  copy_case("stack/five_blocks/five_blocks", root / "in/two");
  ASSERT_EQ(run_keyblock({"batch", root / "in", "--check", "-o", root / "out"}).exit_code, 0);
  write_text(root / "in/one/a30_p20.ana", "broken");
  const ProgramRun again = run_keyblock({"batch", root / "in", "--check", "-o", root / "out", "--resume"});
  EXPECT_TRUE(contains(again.messages, "1 job done before, 1 to do")) << again.messages;
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_EQ(jobs_in(root / "out")[0]["outcome"], "failed");
}

TEST(Batch, a_run_compares_the_old_rules_with_the_new_and_both_with_what_is_expected) {
  const fs::path root = fresh_folder("batch_run");
  copy_case("sliding_block/a30_p20/a30_p20", root / "in/a30_p20");
  fs::copy_file(kCases + "sliding_block/a30_p20/expected.csv", root / "in/a30_p20/expected.csv");
  const ProgramRun run = run_keyblock({"batch", root / "in", "--run", "-o", root / "out"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  const auto job = jobs_in(root / "out").at(0);
  EXPECT_EQ(job["blocks"], 2);
  EXPECT_EQ(job["expected"], "legacy: hold, standard: hold");
  ASSERT_EQ(job["answers"].size(), 2U);
  // g/2 (sin a - cos a tan phi) t^2 at 1 s down a slope of 30 degrees, friction 20 degrees
  const double travel = 0.906407364;
  const auto& standard = job["answers"][1];
  EXPECT_EQ(standard["profile"], "standard");
  EXPECT_NEAR(standard["time"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(std::hypot(standard["dx"].get<double>(), standard["dy"].get<double>()), travel, 1e-6);
  EXPECT_NEAR(job["difference"].get<double>(), 0.0018, 1e-4);  // friction of the Berkeley program lags a step behind
  for (const char* file : {"legacy/run.json", "standard/run.json", "legacy.log", "standard.log"})
    EXPECT_TRUE(fs::exists(root / "out/jobs/a30_p20/a30_p20.geo" / file)) << file;
}

// A block that slides, in a static case; a bar that cannot bend, of which both tasks warn.
TEST(Batch, no_equilibrium_is_a_verdict_of_its_own_and_warnings_are_those_of_the_check) {
  const fs::path root = fresh_folder("batch_mechanism");
  fs::create_directories(root / "in");
  const std::string slides = R"({"keyblock": 2, "run": {"set": {"motion": "static"}},
    "blocks": {"blocks": [{"material": 1, "outer": [[0, 0, 1], [10, 0, 1], [0, 5.7735, 1]]},
                          {"material": 1, "outer": [[4.80385, 3, 1], [5.30385, 3.86603, 1], [3.5718, 4.86603, 1],
                                                    [3.0718, 4, 1]]}],
               "fixed_points": [[1, 1, 1], [8, 0.5, 1]]},
    "analysis": {"step_count": 5, "time_step": 0.01, "block_materials": [{"density": 2000, "youngs_modulus": 1e9}],
                 "joint_materials": [{"friction_angle_deg": 20}]}})";
  write_text(root / "in/slides.json", slides);
  copy_case("toppling_column/a20_r050/a20_r050", root / "in/bar");
  for (const char* task : {"--check", "--run"}) {
    const ProgramRun run = run_keyblock({"batch", root / "in", task, "-o", root / "out" / task});
    EXPECT_EQ(run.exit_code, std::string(task) == "--run" ? 1 : 0) << run.messages;
    const bool is_told = run.messages.find("1 without equilibrium (50 %)") != std::string::npos;
    EXPECT_EQ(is_told, run.exit_code == 1) << run.messages;
    EXPECT_NE(run.messages.find("; 2 with warnings;"), std::string::npos)
        << "also of a job that fails later: " << run.messages;
  }
  const auto checked = jobs_in(root / "out/--check");
  const auto made = jobs_in(root / "out/--run");
  ASSERT_EQ(made.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(checked[i]["warnings"], made[i]["warnings"]) << made[i];
  EXPECT_EQ(made[0]["warnings"], 1);
  EXPECT_NE(made[0]["message"].get<std::string>().find("[block_cannot_bend]"), std::string::npos) << made[0];
  EXPECT_EQ(made[1]["verdict"], "no equilibrium");
  EXPECT_EQ(made[1]["outcome"], "failed");
  EXPECT_EQ(made[1]["answers"][1]["failure"], "no_equilibrium");
  EXPECT_NE(made[1]["why"].get<std::string>().find("block 2 accelerates (at 4.188, 3.933;"), std::string::npos)
      << made[1]["why"];
}

TEST(Batch, a_job_beyond_its_limits_fails_alone) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "under the sanitizer a sound run takes longer than the limit";
#endif
  const fs::path root = fresh_folder("batch_limits");
  copy_case("sliding_block/a30_p20/a30_p20", root / "in");
  std::string endless = read_text(kCases + "block_at_rest/dynamic/dynamic.ana");
  fs::copy_file(kCases + "block_at_rest/dynamic/dynamic.geo", root / "in/endless.geo");
  const std::string steps = "timesteps=\"1000\"";
  ASSERT_NE(endless.find(steps), std::string::npos);
  endless.replace(endless.find(steps), steps.size(), "timesteps=\"100000000\"");
  write_text(root / "in/endless.ana", endless);
  const ProgramRun run =
      run_keyblock({"batch", root / "in", "--run", "--profile", "standard", "--time-limit", "1", "-o", root / "out"});
  EXPECT_EQ(run.exit_code, 1);
  const auto jobs = jobs_in(root / "out");
  EXPECT_EQ(jobs[0]["outcome"], "ok") << jobs[0];
  EXPECT_TRUE(contains(jobs[1]["message"], "stopped at the limit of 1 s of processor time after ")) << jobs[1];
  const int reached = jobs[1]["answers"][0]["steps"];
  EXPECT_GT(reached, 0) << jobs[1];
  const fs::path kept = root / "out" / jobs[1]["outputs"][0].get<std::string>();
  EXPECT_EQ(nlohmann::json::parse(read_text(kept / "run.json"))["outcome"]["steps"], reached);
  EXPECT_TRUE(fs::exists(kept / "checkpoint.h5")) << "a run stopped at its limit can be resumed";
  const ProgramRun starved = run_keyblock(
      {"batch", root / "in", "--run", "--profile", "standard", "--memory-limit", "16", "-o", root / "starved"});
  EXPECT_EQ(starved.exit_code, 1);
  const auto poor = jobs_in(root / "starved")[0];
  EXPECT_EQ(poor["outcome"], "failed");
  EXPECT_TRUE(contains(poor["message"], "the limit of 16 MiB of memory is too small")) << poor;
}

// One exit code stands for both limits.
TEST(Batch, a_run_out_of_memory_is_not_told_as_out_of_time) {
  const fs::path root = fresh_folder("batch_both_limits");
  copy_case("sliding_block/a30_p20/a30_p20", root / "in");
  for (const char* mebibytes : {"24", "33", "34", "36", "38", "42"}) {
    const std::string out = root / mebibytes;
    run_keyblock({"batch", root / "in", "--run", "--profile", "standard", "--memory-limit", mebibytes, "--time-limit",
                  "100", "-o", out});
    const auto job = jobs_in(out)[0];
    EXPECT_FALSE(contains(job["message"], "processor time")) << job;
    EXPECT_TRUE(contains(job["message"], "memory")) << job;
  }
}

TEST(Batch, the_cases_of_an_archive_are_listed_with_their_files_and_nothing_is_written) {
  const fs::path root = fresh_folder("batch_list");
  copy_case("sliding_block/a30_p20/a30_p20", root / "in");
  write_text(root / "in/notes.txt", "no case");
  const ProgramRun listed = run_keyblock({"batch", root / "in", "--list"});
  EXPECT_EQ(listed.exit_code, 0);
  EXPECT_EQ(listed.output, "a30_p20.geo a30_p20.ana\n");
  const auto cases = nlohmann::json::parse(run_keyblock({"batch", root / "in", "--list", "--json"}).output);
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_EQ(cases[0]["files"][1], (root / "in/a30_p20.ana").string());
  EXPECT_EQ(run_keyblock({"batch", root / "none", "--list"}).exit_code, 3);
  EXPECT_EQ(run_keyblock({"batch", root / "in", "--list", "--run"}).exit_code, 2);
}

TEST(Batch, a_check_beyond_its_limits_fails_alone_and_the_others_are_told_as_without_limits) {
  const fs::path root = fresh_folder("batch_check_limits");
  copy_case("sliding_block/a30_p20/a30_p20", root / "in");
  write_text(root / "in/broken.geo", "0.01 4 0 0 0 x");
  std::string grid = "0.01\n2400 2400 0 0 0 0 0 0\n";  // 1,200 lines across 1,200: long to cut
  for (int i = 0; i < 1200; ++i) grid += "0 " + std::to_string(i) + " 1199 " + std::to_string(i) + " 1\n";
  for (int i = 0; i < 1200; ++i) grid += std::to_string(i) + " 0 " + std::to_string(i) + " 1199 1\n";
  const auto outcomes = [&](const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"batch", root / "in", "--check", "-o", root / out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run_keyblock(arguments).exit_code, 1);
    EXPECT_FALSE(fs::exists(root / out / "checks"));
    return jobs_in(root / out);
  };
  EXPECT_EQ(outcomes("limited", {"--time-limit", "100"}), outcomes("free", {}));
  write_text(root / "in/grid.geo", grid);
  bool is_found = false;
  for (const auto& job : outcomes("stopped", {"--time-limit", "1"})) {
    const bool is_grid = contains(job.dump(), "grid.geo");
    is_found = is_found || is_grid;
    EXPECT_EQ(contains(job.dump(), "stopped at the limit of 1 s of processor time"), is_grid) << job;
  }
  EXPECT_TRUE(is_found);
}

// Ctrl-C, `kill`, and a terminal that is closed.
TEST(Batch, an_interrupted_batch_finishes_what_runs_and_exits_130) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const fs::path root = fresh_folder("batch_stopped");
    support::write_mixed_archive(root / "in", 40, 0, 5);
    const ProgramRun run = support::interrupt_keyblock(
        {"batch", root / "in", "--run", "--profile", "legacy", "--time-limit", "20", "-o", root / "out", "--jobs", "1"},
        (root / "out" / "jobs").string(), signal);
    EXPECT_EQ(run.exit_code, 130) << signal << ": " << run.messages;
    EXPECT_FALSE(fs::exists(root / "out" / "catalogue.csv"));
    EXPECT_TRUE(read_text(root / "out" / "journal.jsonl").ends_with("}\n"));
  }
}

// The batch finishes the running job; it was the last one, so that the batch is done.
TEST(Batch, a_stop_during_the_last_job_leaves_nothing_undone) {
  const fs::path root = fresh_folder("batch_stopped_last");
  copy_case("sliding_block/a30_p20/a30_p20", root / "in");
  const ProgramRun run = support::interrupt_keyblock(
      {"batch", root / "in", "--run", "--profile", "legacy", "-o", root / "out", "--jobs", "1"},
      (root / "out" / "jobs").string());
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(fs::exists(root / "out" / "catalogue.csv"));
  EXPECT_EQ(jobs_in(root / "out").at(0)["verdict"], "ran");
}

TEST(Batch, begun_again_it_leaves_nothing_of_the_earlier_one) {
  const fs::path root = fresh_folder("batch_force");
  copy_case("stack/five_blocks/five_blocks", root / "in");
  const std::string in = root / "in", out = root / "out";
  ASSERT_EQ(run_keyblock({"batch", in, "--convert", "berkeley", "-o", out}).exit_code, 0);
  ASSERT_TRUE(fs::exists(root / "out/jobs"));
  write_text(root / "out/jobs/mark", "");  // the user's
  fs::remove_all(root / "in");
  copy_case("sliding_block/a30_p20/a30_p20", root / "in");
  ASSERT_EQ(run_keyblock({"batch", in, "--check", "-o", out, "--force"}).exit_code, 0);
  const auto left = fs::directory_iterator(root / "out/jobs");
  EXPECT_EQ(std::distance(fs::begin(left), fs::end(left)), 1);
  EXPECT_TRUE(fs::exists(root / "out/jobs/mark"));
  EXPECT_EQ(jobs_in(root / "out").at(0)["job"], "a30_p20.geo");
}

TEST(Batch, wrong_usage_and_folders_in_use_are_exit_2) {
  const fs::path root = fresh_folder("batch_usage");
  copy_case("stack/five_blocks/five_blocks", root / "in");
  const std::string in = root / "in";
  const std::string out = root / "out";
  EXPECT_EQ(run_keyblock({"batch", in, "-o", out}).exit_code, 2);
  EXPECT_EQ(run_keyblock({"batch", in, "--check", "--run", "-o", out}).exit_code, 2);
  EXPECT_EQ(run_keyblock({"batch", in, "--check"}).exit_code, 2);
  EXPECT_EQ(run_keyblock({"batch", in + "/none", "--check", "-o", out}).exit_code, 3);
  EXPECT_EQ(run_keyblock({"batch", in, "--check", "-o", out}).exit_code, 0);
  EXPECT_EQ(run_keyblock({"batch", in, "--check", "-o", out}).exit_code, 2);
  EXPECT_EQ(run_keyblock({"batch", in, "--run", "-o", out, "--resume"}).exit_code, 2);
  EXPECT_EQ(run_keyblock({"batch", in, "--check", "-o", out, "--force"}).exit_code, 0);
}

TEST(Batch, results_never_land_on_an_archive_or_among_other_files) {
  const fs::path root = fresh_folder("batch_guard");
  copy_case("stack/five_blocks/five_blocks", root / "jobs");  // place of the results of -o root
  const std::string before = read_text(root / "jobs/five_blocks.geo");
  for (const char* out : {"", "jobs", "jobs/../jobs/"}) {
    const ProgramRun run = run_keyblock({"batch", root / "jobs", "--run", "-o", root / out, "--force"});
    EXPECT_EQ(run.exit_code, 2) << out;
    EXPECT_TRUE(contains(run.messages, "lies in the folder for the results")) << run.messages;
  }
  fs::create_directories(root / "mine");
  write_text(root / "mine/notes", "keep");
  EXPECT_EQ(run_keyblock({"batch", root / "jobs", "--check", "-o", root / "mine", "--force"}).exit_code, 2);
  EXPECT_EQ(read_text(root / "jobs/five_blocks.geo"), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(root / "mine"), {}), 1);
}

TEST(Batch, results_inside_the_archive_are_not_part_of_it) {
  const fs::path root = fresh_folder("batch_inside");
  copy_case("stack/five_blocks/five_blocks", root);
  const std::vector<std::string> batch{"batch", root, "--check", "-o", root / "out"};
  ASSERT_EQ(run_keyblock(batch).exit_code, 0);
  const auto first = catalogue_in(root / "out");
  std::vector<std::string> again = batch;
  again.emplace_back("--force");
  ASSERT_EQ(run_keyblock(again).exit_code, 0);
  EXPECT_EQ(catalogue_in(root / "out"), first);
}

TEST(Batch, a_file_too_large_is_named_and_not_read) {
  const fs::path root = fresh_folder("batch_large");
  fs::create_directories(root / "in");
  write_text(root / "in" / "large.geo", std::string(1100000, '1'));
  EXPECT_EQ(run_keyblock({"batch", root / "in", "--check", "--largest-file", "1", "-o", root / "out"}).exit_code, 1);
  EXPECT_TRUE(contains(jobs_in(root / "out")[0]["message"], "expected at most 1 MiB")) << jobs_in(root / "out")[0];
}

// Names of old archives: "Böschung" in a code page, a per cent sign, and what looks like an escape.
TEST(Batch, files_whose_names_are_not_utf_8_are_in_the_catalogue) {
  const fs::path root = fresh_folder("batch_names");
  copy_case("stack/five_blocks/five_blocks", root / "one");
  for (const std::string& name : {std::string("B\xF6schung"), std::string("50%"), std::string("50%25")})
    for (const char* ending : {".geo", ".ana"}) {
      fs::create_directories(root / "in");
      fs::copy_file(root / "one" / (std::string("five_blocks") + ending), root / "in" / (name + ending));
    }
  for (const std::vector<std::string>& task : {std::vector<std::string>{"--check"}, {"--convert", "berkeley"}}) {
    const fs::path out = root / ("out" + task.front());
    std::vector<std::string> batch{"batch", root / "in", "-o", out};
    batch.insert(batch.end(), task.begin(), task.end());
    const ProgramRun run = run_keyblock(batch);
    EXPECT_EQ(run.exit_code, 0) << run.messages;
    const auto jobs = jobs_in(out);
    ASSERT_EQ(jobs.size(), 3U) << jobs;
    EXPECT_EQ(jobs[0]["job"], "50%25.geo");
    EXPECT_EQ(jobs[1]["job"], "50%2525.geo");
    EXPECT_EQ(jobs[2]["job"], "B%F6schung.geo");
    for (const auto& job : jobs)
      for (const std::string output : job["outputs"]) EXPECT_TRUE(fs::exists(out / output)) << output;
    batch.emplace_back("--resume");
    EXPECT_TRUE(contains(run_keyblock(batch).messages, "3 jobs done before, 0 to do"));
  }
  write_text(root / "in" / "\xF6.geo", "broken");
  EXPECT_EQ(run_keyblock({"batch", root / "in", "--check", "-o", root / "broken"}).exit_code, 1);
  EXPECT_TRUE(jobs_in(root / "broken")[0]["message"].get<std::string>().starts_with("%F6.geo:"))
      << jobs_in(root / "broken")[0];
}

// The limit of address space is that of the whole batch; the numbers of the file alone take more.
TEST(Batch, a_file_that_memory_does_not_suffice_for_fails_alone) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer reserves more than any limit";
#endif
  const fs::path root = fresh_folder("batch_memory");
  copy_case("stack/five_blocks/five_blocks", root / "in");
  std::string ones(60U << 20U, '1');
  for (std::size_t i = 1; i < ones.size(); i += 2) ones[i] = ' ';
  write_text(root / "in/ones.geo", ones);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  const rlimit narrow{250U << 20U, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_AS, &narrow), 0);
  const ProgramRun run = run_keyblock({"batch", root / "in", "--check", "--jobs", "1", "-o", root / "out"});
  ASSERT_EQ(setrlimit(RLIMIT_AS, &before), 0);
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  const auto jobs = jobs_in(root / "out");
  ASSERT_EQ(jobs.size(), 2U) << jobs;
  EXPECT_NE(jobs[0]["outcome"], "failed") << jobs[0];
  EXPECT_EQ(jobs[1]["message"], "ones.geo: error: there is not enough memory for this");
}

TEST(Batch, every_case_is_converted_and_comes_back_as_the_same_scene) {
  const fs::path root = fresh_folder("batch_convert");
  copy_case("stack/five_blocks/five_blocks", root / "in");
  copy_case("sliding_block/a30_p20/a30_p20", root / "in/slope");
  const ProgramRun run = run_keyblock({"batch", root / "in", "--convert", "keyblock-case", "-o", root / "out"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  const auto jobs = jobs_in(root / "out");
  ASSERT_EQ(jobs.size(), 2U);
  run_keyblock({"batch", root / "out/jobs", "--check", "-o", root / "again"});
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(jobs[i]["outputs"].size(), 1U) << jobs[i];
    const std::string output = jobs[i]["outputs"][0];
    EXPECT_TRUE(fs::exists(root / "out" / output)) << output;
    const auto again = jobs_in(root / "again");
    const auto found = std::ranges::find_if(
        again, [&](const auto& job) { return "jobs/" + job["job"].template get<std::string>() == output; });
    ASSERT_NE(found, again.end());
    EXPECT_EQ((*found)["blocks"], jobs[i]["blocks"]);
  }
  EXPECT_EQ(run_keyblock({"batch", root / "in", "--convert", "paper", "-o", root / "none"}).exit_code, 2);
}

// A bar fixed at two points under a load, by Shi's static steps. Few of them reach a small part of the equilibrium, as
// the far longer steps of the second file and the equilibria show. 5 % is left for the modes beside the slowest.
TEST(Batch, manifold_pairs_are_catalogued_with_their_scene_and_what_both_profiles_come_to) {
  const fs::path root = fresh_folder("batch_pairs_on_covers");
  write_text(root / "bar.geo",
             "0.001\n4 0\n0\n0\n2\n1\n0\n0\n0 0 2 0 1\n2 0 2 1 1\n2 1 0 1 1\n0 1 0 0 1\n0.1 0.05 0.1 0.05\n"
             "1.9 0.05 1.9 0.05\n1 0.95\n");
  fs::create_directories(root / "in");
  ASSERT_EQ(run_keyblock({"cut", root / "bar.geo", "--mesh", "2", "-o", root / "in/cv01"}).exit_code, 0);
  fs::copy_file(root / "in/cv01", root / "in/cv02");
  const auto controls = [](const std::string& time_step) {
    return "0\n20\n1\n1\n0.1\n" + time_step +
           "\n1000\n0 -1\n1\n0 0\n100 0.25\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n1.6\n0 0 0\n";
  };
  write_text(root / "in/mf01", controls("0.03"));
  write_text(root / "in/mf02", controls("10"));
  const ProgramRun run = run_keyblock({"batch", root / "in", "--run", "-o", root / "out"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  const auto jobs = jobs_in(root / "out");
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_EQ(jobs[0]["scene"],
            "static, 20 steps of 0.03; 1 piece, fixed, of 40 elements on 29 covers; 1 point load of up to 1; E 100, "
            "Poisson's ratio 0.25; no weight; friction 0 degrees");
  const auto measures = [&](int job, int profile) { return jobs[job]["answers"].at(profile)["measures"]; };
  const double creeping = measures(0, 0)["displacement"];
  const double settled = measures(1, 0)["displacement"];
  EXPECT_NEAR(measures(0, 0)["equilibrium_share"].get<double>(), creeping / settled, 0.05);
  EXPECT_LT(creeping / settled, 0.7);
  EXPECT_NEAR(measures(1, 0)["equilibrium_share"].get<double>(), 1, 1e-3);
  for (const int job : {0, 1}) {
    EXPECT_EQ(measures(job, 1)["equilibrium_share"], 1);
    EXPECT_LT(measures(job, 1)["least_stress"], -1) << "the load presses";
    EXPECT_GT(measures(job, 1)["greatest_stress"], 0.5) << "the bar bends";
    EXPECT_EQ(measures(job, 1)["contacts"], 0);
  }
  EXPECT_EQ(measures(0, 1)["displacement"], measures(1, 1)["displacement"]);
  EXPECT_GT(measures(0, 1)["displacement"], settled) << "more is free to bend than in first order";
  EXPECT_TRUE(contains(
      run_keyblock({"run", root / "in/cv02", root / "in/mf02", "--profile", "standard", "-o", root / "run"}).messages,
      "  motion    in equilibrium"));
}

// 01 pushes a wedge along a joint without friction; 07 unwinds a clock spring, whose end moves by twice the width of
// the scene.
TEST(Batch, old_manifold_pairs_come_to_a_row_each_in_both_profiles) {
  if (!has_sample_covers()) GTEST_SKIP() << "no samples; name their folder in KEYBLOCK_SHARED";
  const fs::path root = fresh_folder("batch_samples");
  fs::create_directories(root / "in");
  for (const char* number : {"01", "02", "07"})
    for (const char* part : {"cv", "mf"})
      fs::copy_file(sample_covers() / (std::string(part) + number), root / "in" / (std::string(part) + number));
  const ProgramRun run = run_keyblock({"batch", root / "in", "--run", "-o", root / "out"});
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  const auto jobs = jobs_in(root / "out");
  ASSERT_EQ(jobs.size(), 3U);
  EXPECT_TRUE(contains(jobs[0]["scene"], "2 pieces, 1 of them fixed, of 43 elements on 37 covers; no point load"));
  for (const char* part : {"no equilibrium: element 22 accelerates (at ", "; its body has fewer than two fixed points"})
    EXPECT_TRUE(contains(jobs[0]["answers"][1]["end"], part)) << jobs[0];
  for (const int job : {0, 1, 2}) {
    const auto& legacy = jobs[job]["answers"][0];
    EXPECT_EQ(legacy["end"], "finished");
    EXPECT_TRUE(legacy["measures"]["is_static"]);
    const auto& share = legacy["measures"]["equilibrium_share"];
    EXPECT_TRUE(share.is_null() || share < 0.2) << "the old static steps creep";
  }
  for (const int job : {1, 2}) {
    EXPECT_EQ(jobs[job]["answers"][1]["end"], "finished") << jobs[job];
    EXPECT_EQ(jobs[job]["answers"][1]["measures"]["equilibrium_share"], 1);
  }
  EXPECT_NEAR(jobs[2]["answers"][1]["measures"]["displacement"].get<double>(), 18.83, 0.02);
}

}  // namespace keyblock::batch_test
