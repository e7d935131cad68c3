// One way in: only api prepares a case, and no decision reads a sentence of the program.
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

}  // namespace keyblock::front_door_test
