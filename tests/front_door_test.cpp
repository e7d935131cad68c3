// One way in: only api prepares a case, no decision reads a sentence of the program, and below the program nothing
// prints or changes the process.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <string>
#include <string_view>

namespace keyblock::front_door_test {
namespace {

namespace fs = std::filesystem;

using Look = std::function<void(const std::string& file, const std::string& code, int line)>;

/// Gives each line of the sources, without its comment.
void each_line(const Look& look) {
  const fs::path root(KEYBLOCK_SOURCE_DIR);
  for (const char* folder : {"src", "formats"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      std::ifstream text(entry.path());
      int number = 0;
      for (std::string line; std::getline(text, line);)
        look(fs::relative(entry.path(), root).generic_string(), line.substr(0, line.find("//")), ++number);
    }
  }
}

// Names that hold sentences: searched, cut, or compared with a text that is not empty.
const std::regex& reads_a_sentence() {
  static const std::regex kReads(
      R"(\b(what\(\)|sentence(\(\))?|reason|why|failure|doubt|message|complaint))"
      R"(((\.|->)(find|rfind|starts_with|ends_with|contains|substr|compare)\(| (==|!=) "[^"]))");
  return kReads;
}

/// Quick test for lines that the slower expression may match.
bool may_read(std::string_view code) {
  constexpr std::array<std::string_view, 8> kParts{"find(",   "starts_with(", "ends_with(", "contains(",
                                                   "substr(", "compare(",     "== \"",      "!= \""};
  return std::ranges::any_of(kParts, [&](std::string_view part) { return code.find(part) != std::string_view::npos; });
}

bool is_in(std::string_view file, std::string_view room) {
  return file.starts_with("src/" + std::string(room) + "/");
}

// Output to the terminal, working directory, environment, signals, end of the process.
const std::regex& prints_or_changes_the_process() {
  static const std::regex kDoes(
      R"(std::(cout|cerr|clog)\b|\bspdlog::|\bfmt::print\(|\b(printf|fprintf|puts|fputs|perror)\()"
      R"(|\b(chdir|fchdir|setenv|putenv|unsetenv|setlocale|umask|signal|sigaction|exit|_exit|abort)\()"
      R"(|\bcurrent_path\([^e)])");
  return kDoes;
}

// Variables that live as long as the process and may change: static members and locals, variables of a thread.
const std::regex& keeps_state() {
  static const std::regex kKeeps(R"(^\s*(inline )?(static|thread_local) (?!(inline )?(constexpr|consteval)\b))"
                                 R"((?!.*\bconst [a-z_]+ *[={;])(?!const [^*;={<]*(<[^>]*>)?[^*;={]*[;={])[^(]*[;={])");
  return kKeeps;
}

}  // namespace

// Codes and values decide: `Warning::name`, `Facts`, `FailureKind`.
TEST(FrontDoor, no_decision_reads_a_sentence) {
  // Takes the path of its own folder out of a message, which it shows.
  constexpr std::string_view kShortens = "src/app/batch/sweep_jobs.cpp";
  // Kind of a failure in run.json, a word of `word_for`.
  constexpr std::string_view kWordOfFailure = "src/study/batch/batch_verdict.cpp";
  int lines = 0;
  each_line([&](const std::string& file, const std::string& code, int line) {
    ++lines;
    if (!may_read(code) || file == kShortens || file == kWordOfFailure) return;
    EXPECT_FALSE(std::regex_search(code, reads_a_sentence())) << file << ":" << line << ": " << code;
  });
  EXPECT_GT(lines, 80'000);
}

TEST(FrontDoor, the_search_for_sentences_finds_them) {
  for (const char* const code :
       {R"(if (error.what().find("turned")) return)", R"(loss.sentence.starts_with("nothing"))",
        R"(return outcome.reason == "stopped";)", R"(after.why.substr(3))"})
    EXPECT_TRUE(may_read(code) && std::regex_search(code, reads_a_sentence())) << code;
  for (const char* const code : {R"(if (error.what() != nullptr) return)", R"(outcome.reason.empty())",
                                 R"(outcome.reason == "")", R"(find(warnings, &Warning::name))"})
    EXPECT_FALSE(std::regex_search(code, reads_a_sentence())) << code;
}

TEST(FrontDoor, only_api_reads_case_json_and_prepares) {
  int in_api = 0;
  const std::regex prepares(R"((^|[^.>\w])prepare\()");
  each_line([&](const std::string& file, const std::string& code, int line) {
    const bool reads = code.find("\"case.json\"") != std::string::npos;
    const bool follows = code.find("with_named_files(") != std::string::npos;
    const bool makes = code.find("prepare(") != std::string::npos && !is_in(file, "run") && !is_in(file, "contact") &&
                       std::regex_search(code, prepares);
    if (!reads && !follows && !makes) return;
    if (is_in(file, "api"))
      ++in_api;
    else
      ADD_FAILURE() << file << ":" << line << ": " << code;
  });
  EXPECT_GE(in_api, 3) << "the search finds what api does";
}

// The library is called by programs that own terminal, folder and signals, and that make many runs at once.
TEST(FrontDoor, only_the_program_prints_or_changes_the_process) {
  // Contexts of threads; numbers in the names of temporary files; one factorisation of CHOLMOD, and one call of HDF5,
  // at a time.
  constexpr std::array<std::string_view, 4> kKeep{"src/base/context.cpp", "src/job/files.cpp", "src/run/checkpoint.cpp",
                                                  "src/system/cholmod/sparse_factor.cpp"};
  int kept = 0;
  each_line([&](const std::string& file, const std::string& code, int line) {
    if (is_in(file, "app") || is_in(file, "serve")) return;
    if (code.find('(') != std::string::npos || code.find("std::c") != std::string::npos) {
      EXPECT_FALSE(std::regex_search(code, prints_or_changes_the_process())) << file << ":" << line << ": " << code;
    }
    if (code.find("static ") == std::string::npos && code.find("thread_local ") == std::string::npos) return;
    if (!std::regex_search(code, keeps_state())) return;
    ++kept;
    EXPECT_TRUE(std::ranges::find(kKeep, file) != kKeep.end()) << file << ":" << line << ": " << code;
  });
  EXPECT_EQ(kept, 4);
}

TEST(FrontDoor, the_search_for_output_and_state_finds_them) {
  for (const char* const code :
       {R"(std::cerr << "lost";)", R"(spdlog::warn("lost");)", R"(fmt::print("{}", 1);)", R"(if (chdir(folder) != 0))",
        R"(fs::current_path(folder);)", R"(std::signal(SIGINT, SIG_DFL);)", R"(std::exit(1);)"})
    EXPECT_TRUE(std::regex_search(code, prints_or_changes_the_process())) << code;
  for (const char* const code : {R"(snprintf(text, 3, "%d", 1);)", R"(fs::current_path();)",
                                 R"(fs::current_path(error);)", R"(file << "text";)", R"(run.exit_code();)"})
    EXPECT_FALSE(std::regex_search(code, prints_or_changes_the_process())) << code;
  for (const char* const code : {"  static int count = 0;", "static std::vector<double> rows;",
                                 "thread_local int depth;", "  static std::atomic<unsigned> count{0};"})
    EXPECT_TRUE(std::regex_search(code, keeps_state())) << code;
  for (const char* const code :
       {"static constexpr int kMost = 3;", "static const auto call = found;", "static double area(const Loop& loop) {",
        "static void* const handle = open();", "  static const EVP_MD* const found = fetch();"})
    EXPECT_FALSE(std::regex_search(code, keeps_state())) << code;
}

}  // namespace keyblock::front_door_test
