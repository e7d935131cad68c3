// The shell: messages for typing errors, the stream of each output, and messages that name the remedy.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "app/step_pace.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::shell_test {
namespace {

using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using support::write_text;

const std::string kSlide = KEYBLOCK_SOURCE_DIR "/legacy_cases/sliding_block/a30_p20/a30_p20";
const std::string kCircle = KEYBLOCK_SOURCE_DIR "/legacy_cases/circle_slope/circle_slope";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::vector<std::string> slide_into(const std::string& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> all{"run", kSlide + ".geo", kSlide + ".ana", "-o", out, "--set", "steps=2"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

TEST(Shell, slips_are_told_the_nearest_name) {
  EXPECT_TRUE(contains(run_keyblock({"rnu"}).messages, "did you mean \"run\"?"));
  const ProgramRun option = run_keyblock({"run", "a.json", "--outptu", "x"});
  EXPECT_EQ(option.exit_code, 2);
  EXPECT_TRUE(contains(option.messages, "there is no option --outptu; did you mean --output?")) << option.messages;
  EXPECT_TRUE(contains(run_keyblock({"run", "a.json", "--out", "x"}).messages,
                       "there is no option --out; did you mean --output?"));
  const ProgramRun setting = run_keyblock(slide_into(fresh_folder("slip") + "/out", {"--set", "motoin=static"}));
  EXPECT_TRUE(contains(setting.messages, "did you mean \"motion\"?")) << setting.messages;
  const ProgramRun value = run_keyblock(slide_into(fresh_folder("slip") + "/out", {"--set", "friction_angle=30"}));
  EXPECT_EQ(value.exit_code, 2);
  EXPECT_TRUE(contains(value.messages, "there is no setting \"friction_angle\"; it is a value of joint_materials in"))
      << value.messages;
  const std::string folder = fresh_folder("slip_key");
  write_text(folder + "/a.json", R"({"keyblock": 1, "analyssi": {}})");
  EXPECT_TRUE(contains(run_keyblock({"check", folder + "/a.json"}).messages, "did you mean \"analysis\"?"));
}

TEST(Shell, every_command_shows_examples) {
  for (const char* command :
       {"new",      "check", "cut",   "joints",  "run",     "plot", "view",    "serve",   "fos",   "compare",
        "tradeoff", "sweep", "batch", "convert", "element", "fit",  "formats", "explain", "shell", "version"}) {
    const ProgramRun help = run_keyblock({command, "--help"});
    EXPECT_TRUE(contains(help.output, std::string("Examples:\n  keyblock ") + command)) << help.output;
  }
}

// Names, arguments, sentences in lines of a terminal; none of the parser's own words for its checks.
TEST(Shell, help_says_what_options_take_in_plain_words) {
  for (const char* command : {"check", "cut", "joints", "run", "plot", "view", "serve", "fos", "sif", "compare",
                              "tradeoff", "sweep", "batch", "convert", "element", "fit", "new"}) {
    const std::string help = run_keyblock({command, "--help"}).output;
    for (const char* raw : {"TEXT", "ENUM", "FLOAT", "UINT", "Excludes", "Needs", "->", " in [", "{"})
      EXPECT_FALSE(contains(help, raw)) << command << ": " << raw << "\n" << help;
    std::istringstream lines(help.substr(0, help.find("\nExamples:")));
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with(std::string(28, ' '))) {
        EXPECT_TRUE(line.size() <= 100 || line.find(' ', 28) == std::string::npos) << line;
      }
    }
  }
  const std::string run = run_keyblock({"run", "--help"}).output;
  EXPECT_TRUE(contains(run, "\n  -o,--output FOLDER        folder for the results (default: out; with")) << run;
  EXPECT_TRUE(contains(run, "\n  --set KEY=VALUE...        change one setting of the profile")) << run;
  EXPECT_TRUE(contains(run, "\n  --reduce-strength joints|rock|both\n")) << run;
}

// A block that slides, in coordinates of a survey.
TEST(Shell, places_are_told_without_powers_of_ten) {
  const std::string folder = fresh_folder("survey");
  write_text(folder + "/a.json", R"({"keyblock": 2, "blocks": {"blocks": [
      {"outer": [[12470, 50310, 1], [12480, 50310, 1], [12470, 50315.7735, 1]]},
      {"outer": [[12474.80385, 50313, 1], [12475.30385, 50313.86603, 1], [12473.5718, 50314.86603, 1],
                 [12473.0718, 50314, 1]]}], "fixed_points": [[12471, 50311, 1], [12478, 50310.5, 1]]},
    "analysis": {"step_count": 5, "time_step": 0.01, "block_materials": [{"density": 2000, "youngs_modulus": 1e9}],
                 "joint_materials": [{"friction_angle_deg": 20}]}})");
  const ProgramRun run = run_keyblock({"run", folder + "/a.json", "-o", folder + "/out", "--set", "motion=static"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_TRUE(contains(run.messages, "block 2 accelerates (at 12474, 50314; area 2,")) << run.messages;
}

// Neither is written by hand: both list the same options as --help.
TEST(Shell, man_page_and_completion_name_all_commands_and_options) {
  const std::string man = run_keyblock({"shell", "man"}).output;
  const std::string bash = run_keyblock({"shell", "bash"}).output;
  std::istringstream help(run_keyblock({"--help"}).output);
  int commands = 0;
  bool has_begun = false;
  for (std::string line; std::getline(help, line);) {
    if (has_begun && line.starts_with("  ") && line[2] != ' ') {
      const std::string name = line.substr(2, line.find(' ', 2) - 2);
      ++commands;
      EXPECT_TRUE(contains(man, "\n.SS keyblock " + name + "\n")) << name;
      EXPECT_TRUE(contains(bash, "    " + name + ") options+=")) << name;
      std::istringstream words(run_keyblock({name, "--help"}).output);
      for (std::string word; words >> word;) {
        const std::string option = word.substr(word.starts_with("-") && word[1] != '-' ? word.find(',') + 1 : 0);
        if (!option.starts_with("--") || option.size() < 4 || option.find_first_of(".,;:)=`\"") != std::string::npos)
          continue;
        EXPECT_TRUE(contains(bash, option)) << name << " " << option;
      }
    }
    has_begun = has_begun || line == "Subcommands:";
  }
  EXPECT_GE(commands, 19);
}

TEST(Shell, help_says_what_is_required_and_the_man_page_has_its_defaults_and_all_exit_codes) {
  const std::string man = run_keyblock({"shell", "man"}).output;
  // The text of --help in brackets, in one line with the hyphens of roff.
  for (const char* words : {"are listed, not read (default: 64)", "into the picture if they fit (with \\-\\-svg)",
                            "else geometry file (required)", "jobs at a time (default: number of cores) [1 to 1024]"})
    EXPECT_TRUE(contains(man, words)) << words;
  for (const char* code : {"0", "1", "2", "3", "4", "5", "130", "128 + n"})
    EXPECT_TRUE(contains(man, fmt::format("\\fB{}\\fR\n", code))) << code;
  EXPECT_TRUE(contains(run_keyblock({"batch", "--help"}).output, "(required)"));
  EXPECT_TRUE(contains(run_keyblock({"run", "--help"}).output, "folder for the results (default: out; with"));
  EXPECT_FALSE(contains(run_keyblock({"joints", "--help"}).output, ".hpp"));
}

TEST(Shell, bash_completes_commands_options_and_values) {
  const std::string script = fresh_folder("completion") + "/keyblock.bash";
  write_text(script, run_keyblock({"shell", "bash"}).output);
  const auto completed = [&](const std::string& words) {
    const ProgramRun run =
        support::run_script("bash -c '. " + script + "; COMP_WORDS=(keyblock " + words +
                            "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _keyblock; echo ${COMPREPLY[*]}'");
    EXPECT_EQ(run.exit_code, 0) << run.messages;
    return run.output;
  };
  EXPECT_EQ(completed("conv"), "convert\n");
  EXPECT_EQ(completed("run --fiel"), "--field\n");
  EXPECT_EQ(completed("run --field s"), "sxx syy sxy s1 s3\n");
  EXPECT_EQ(completed("new a"), "arch\n");
  EXPECT_EQ(completed("--qui"), "--quiet\n");
  EXPECT_EQ(completed("--log run new a"), "arch\n");  // the name of a log is no command
}

TEST(Shell, settings_come_in_groups_those_set_first_ahead) {
  const std::string text = run_keyblock({"run", "--settings"}).output;
  const std::size_t first = text.find("# set first");
  const std::size_t quirks = text.find("# rules of the Berkeley program");
  ASSERT_NE(first, std::string::npos) << text;
  ASSERT_NE(quirks, std::string::npos);
  for (const char* name : {"\nmotion ", "\ncontact_penalty ", "\nenforcement ", "\njoint_strength_factor "}) {
    EXPECT_LT(text.find(name), text.find("# read by all")) << name;
    EXPECT_GT(text.find(name), first) << name;
  }
  EXPECT_GT(text.find("\nquirk."), quirks);
}

// After 20 steps, or two seconds of them, a run of a million steps estimates its time; a short run does not.
TEST(Shell, a_long_run_estimates_its_time_if_verbose) {
  const std::string folder = fresh_folder("forecast");
  ASSERT_EQ(run_keyblock({"new", "slope", "-o", folder + "/slope.json"}).exit_code, 0);
  const std::string out = folder + "/long";
  const ProgramRun run = support::interrupt_keyblock(
      {"run", folder + "/slope.json", "-o", out, "--set", "steps=1000000", "--verbose"}, out + "/step_table.csv");
  EXPECT_EQ(run.exit_code, 130) << run.messages;
  EXPECT_TRUE(contains(run.messages, "estimate after ")) << run.messages;
  EXPECT_TRUE(contains(run.messages, " s per step, about ")) << run.messages;
  std::smatch said;
  ASSERT_TRUE(
      std::regex_search(run.messages, said, std::regex("estimate after (\\d+) steps?: .* for the remaining (\\d+)")))
      << run.messages;
  EXPECT_EQ(std::stoi(said[1]) + std::stoi(said[2]), 1'000'000);
  EXPECT_FALSE(contains(run_keyblock(slide_into(folder + "/short")).messages, "estimate after"));
}

// Sixteen steps of 10 s each before steps of 1 s: the mean of all is 5 s after 36 steps.
TEST(StepPace, a_hard_start_is_forgotten) {
  StepPace pace;
  double seconds = 100;  // the initial state
  for (int step = 1; step <= 36; ++step) {
    seconds += step <= 16 ? 10 : 1;
    pace.made(step, seconds);
    if (step == 1) {
      EXPECT_DOUBLE_EQ(pace.seconds_a_step(), 110);
    }
    if (step == 2) {
      EXPECT_DOUBLE_EQ(pace.seconds_a_step(), 10);
    }
  }
  EXPECT_DOUBLE_EQ(pace.seconds_a_step(), 1);
}

TEST(Shell, quiet_says_errors_alone_and_a_log_keeps_all) {
  const std::string folder = fresh_folder("quiet");
  const ProgramRun quiet = run_keyblock(slide_into(folder + "/a", {"--quiet"}));
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.messages, "");
  const ProgramRun logged = run_keyblock(slide_into(folder + "/b", {"--log", folder + "/log.txt"}));
  EXPECT_TRUE(contains(logged.messages, "2 steps, t = "));
  EXPECT_TRUE(contains(read_text(folder + "/log.txt"), "2 steps, t = "));
  const ProgramRun both = run_keyblock(slide_into(folder + "/f", {"--quiet", "--log", folder + "/quiet.txt"}));
  EXPECT_EQ(both.messages, "");
  EXPECT_TRUE(contains(read_text(folder + "/quiet.txt"), "2 steps, t = "));
  const ProgramRun verbose = run_keyblock(slide_into(folder + "/c", {"--verbose"}));
  EXPECT_TRUE(contains(verbose.messages, "read in ")) << verbose.messages;
  EXPECT_TRUE(contains(run_keyblock({"--quiet", "run", "none.json", "-o", folder + "/d"}).messages, "error:"));
  EXPECT_EQ(run_keyblock(slide_into(folder + "/e", {"--quiet", "--verbose"})).exit_code, 2);
}

TEST(Shell, no_log_is_written_into_what_the_command_reads) {
  const std::string file = fresh_folder("log_apart") + "/case.json";
  ASSERT_EQ(run_keyblock({"new", "block", "-o", file}).exit_code, 0);
  const std::string before = read_text(file);
  for (const std::vector<std::string>& log : {std::vector<std::string>{"--log", file}, {"--log=" + file}}) {
    std::vector<std::string> words{"check", file};
    words.insert(words.end(), log.begin(), log.end());
    const ProgramRun run = run_keyblock(words);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(contains(run.messages, "expected a new file, or one whose name ends in .log")) << run.messages;
  }
  const std::string link = file + ".log";
  for (const bool is_hard : {false, true}) {
    std::filesystem::remove(link);
    if (is_hard)
      std::filesystem::create_hard_link(file, link);
    else
      std::filesystem::create_symlink(file, link);
    EXPECT_EQ(run_keyblock({"check", file, "--log", link}).exit_code, 2) << is_hard;
  }
  EXPECT_EQ(read_text(file), before);
}

TEST(Shell, a_word_that_is_none_of_those_of_an_option_is_asked_about) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"new", "slop"}, {"check", "x", "--profile", "standart"}}) {
    const ProgramRun run = run_keyblock(words);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(contains(run.messages, "did you mean \"s")) << run.messages;
  }
}

// Without a terminal there are no colours, for any TERM.
TEST(Shell, no_colours_go_where_no_terminal_is) {
  const ProgramRun run = support::run_script("TERM=xterm-256color \"$K\" check none.json");
  EXPECT_TRUE(contains(run.messages, "error:")) << run.messages;
  EXPECT_FALSE(contains(run.messages, "\x1b["));
}

TEST(Shell, version_says_which_program_it_is) {
  const ProgramRun version = run_keyblock({"version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_TRUE(version.output.starts_with("keyblock ")) << version.output;
  EXPECT_EQ(run_keyblock({"--version"}).output, version.output);
}

TEST(Shell, check_takes_the_folder_of_a_case) {
  const ProgramRun one = run_keyblock({"check", KEYBLOCK_SOURCE_DIR "/legacy_cases/circle_slope"});
  EXPECT_EQ(one.exit_code, 0) << one.messages;
  EXPECT_TRUE(contains(one.output, "circle_slope.geo")) << one.output;
  const ProgramRun many = run_keyblock({"check", KEYBLOCK_SOURCE_DIR "/legacy_cases", kCircle + ".geo"});
  EXPECT_EQ(many.exit_code, 2);
  EXPECT_TRUE(contains(many.messages, "among others")) << many.messages;
}

TEST(Shell, check_of_a_folder_without_cases_is_an_error) {
  const std::string folder = fresh_folder("check_empty");
  const ProgramRun empty = run_keyblock({"check", folder});
  EXPECT_EQ(empty.exit_code, 3) << empty.output;
  EXPECT_TRUE(contains(empty.messages, folder + ": error: expected files of cases in the folder, found none"))
      << empty.messages;
}

// One verdict per line, the exit code of the worst, nothing written.
TEST(Shell, check_of_a_folder_of_cases_says_a_verdict_a_line) {
  const std::string folder = fresh_folder("check_folder");
  for (const char* name : {"a", "b"})
    for (const char* ending : {".geo", ".ana"}) write_text(folder + "/" + name + ending, read_text(kSlide + ending));
  write_text(folder + "/notes.txt", "hello");
  const ProgramRun good = run_keyblock({"check", folder});
  EXPECT_EQ(good.exit_code, 0) << good.output << good.messages;
  EXPECT_TRUE(contains(good.output, "  a.geo")) << good.output;
  EXPECT_TRUE(contains(good.output, "  b.geo")) << good.output;
  EXPECT_TRUE(contains(good.output, "0 failed")) << good.output;
  write_text(folder + "/b.geo", read_text(kSlide + ".geo").substr(0, 300));
  const ProgramRun bad = run_keyblock({"check", folder});
  EXPECT_EQ(bad.exit_code, 3) << bad.output;
  EXPECT_TRUE(contains(bad.output, "failed    b.geo: ")) << bad.output;
  const ProgramRun json = run_keyblock({"check", folder, "--json"});
  EXPECT_EQ(json.exit_code, 3);
  const auto rows = nlohmann::json::parse(json.output).at("jobs");
  bool is_told = false;
  for (const auto& row : rows)
    if (row.at("job") == "b.geo" && row.at("outcome") == "failed") is_told = true;
  EXPECT_TRUE(is_told) << json.output;
}

TEST(Shell, every_list_is_printed_as_json_too) {
  const auto version = nlohmann::json::parse(run_keyblock({"version", "--json"}).output);
  EXPECT_TRUE(version.contains("commit"));
  const auto settings = nlohmann::json::parse(run_keyblock({"run", "--settings", "--json"}).output);
  ASSERT_GT(settings.size(), 40U);
  EXPECT_EQ(settings[0].at("group"), "set first");
  EXPECT_TRUE(settings[0].at("profiles").contains("legacy"));
  const std::string folder = fresh_folder("new_json");
  const ProgramRun made = run_keyblock({"new", "block", "-o", folder + "/b.json", "--json"});
  EXPECT_EQ(nlohmann::json::parse(made.output).at("kind"), "block");
  for (const char* command : {"check", "cut", "joints", "run", "plot", "view", "fos", "sif", "compare", "tradeoff",
                              "sweep", "batch", "convert", "element", "fit", "formats", "explain", "new", "version"})
    EXPECT_TRUE(contains(run_keyblock({command, "--help"}).output, "--json")) << command;
}

// Messages that did not help three new users, in their new wording. Those of statics and of legacy's limits are in
// profile_choice_test.cpp.
TEST(Shell, messages_say_what_to_do) {
  const std::string folder = fresh_folder("messages");
  const ProgramRun alone = run_keyblock({"run", kSlide + ".geo", "-o", folder + "/a"});
  EXPECT_EQ(alone.exit_code, 3);
  EXPECT_TRUE(contains(alone.messages, "expected an analysis for it")) << alone.messages;
  EXPECT_TRUE(contains(alone.messages, "keyblock new block")) << alone.messages;
  write_text(folder + "/none.json", R"({"keyblock": 1, "analysis": {"step_count": 1, "time_step": 1}})");
  const ProgramRun missing = run_keyblock({"check", folder + "/none.json"});
  EXPECT_TRUE(
      contains(missing.messages, "expected the key allowed_displacement_ratio of analysis: greater than 0, found none"))
      << missing.messages;
}

TEST(Shell, a_missing_modulus_is_missing_and_no_object) {
  const std::string folder = fresh_folder("missing_modulus");
  write_text(folder + "/none.json", R"({"keyblock": 2, "analysis": {"step_count": 1, "time_step": 1,
    "block_materials": [{"density": 1, "poissons_ratio": 0}], "joint_materials": [{}]}})");
  const ProgramRun missing = run_keyblock({"check", folder + "/none.json"});
  EXPECT_TRUE(contains(missing.messages, "youngs_modulus")) << missing.messages;
  EXPECT_TRUE(contains(missing.messages, "found none")) << missing.messages;
}

// The note appears only if the user chose a start.
TEST(Shell, a_start_that_nobody_asked_for_is_no_warning) {
  const std::string folder = fresh_folder("start");
  ASSERT_EQ(run_keyblock({"new", "arch", "-o", folder + "/arch.json"}).exit_code, 0);
  const ProgramRun run = run_keyblock({"run", folder + "/arch.json", "-o", folder + "/out", "--set", "steps=2"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_FALSE(contains(run.messages, "start_settled")) << run.messages;
}

// An unknown setting is refused with the nearest known one; warnings come before the first step.
TEST(Shell, a_setting_that_is_none_has_a_nearest_and_warnings_come_first) {
  const ProgramRun setting =
      run_keyblock(slide_into(fresh_folder("nearest") + "/out", {"--set", "joint_strength_facto=0.9"}));
  EXPECT_EQ(setting.exit_code, 2);
  EXPECT_TRUE(contains(setting.messages, "did you mean \"joint_strength_factor\"?")) << setting.messages;
  const std::string folder = fresh_folder("warned_first");
  write_text(folder + "/weightless.json", R"({"keyblock": 1,
 "blocks": {"blocks": [{"outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1]]}], "fixed_points": [[0.5, 0.25, 1]]},
 "analysis": {"step_count": 2, "time_step": 0.01, "allowed_displacement_ratio": 0.1,
  "block_materials": [{"density": 1, "youngs_modulus": 1e6}], "joint_materials": [{}]}})");
  const ProgramRun run = run_keyblock({"run", folder + "/weightless.json", "-o", folder + "/out"});
  const std::size_t warning = run.messages.find("blocks of this material are weightless");
  const std::size_t end = run.messages.find("2 steps, t = ");
  ASSERT_NE(end, std::string::npos) << run.messages;
  ASSERT_NE(warning, std::string::npos) << run.messages;
  EXPECT_LT(warning, end) << run.messages;
}

// Missing unit weights give no warning in a case with gravity.
TEST(Shell, gravity_without_unit_weights_is_no_warning) {
  const std::string folder = fresh_folder("weights");
  ASSERT_EQ(run_keyblock({"new", "block", "-o", folder + "/block.json"}).exit_code, 0);
  const ProgramRun check = run_keyblock({"check", folder + "/block.json"});
  EXPECT_FALSE(contains(check.output, "unit_weight_without_effect")) << check.output;
}

}  // namespace keyblock::shell_test
