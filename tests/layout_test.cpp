// The layout that every source keeps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock::layout_test {
namespace {

namespace fs = std::filesystem;

constexpr int kLongest = 120;  // characters, as .clang-format has it; it leaves comments and texts as they are

int characters(const std::string& line) {
  int count = 0;
  for (const char c : line) count += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // not inside one of UTF-8
  return count;
}

bool is_source(const fs::path& file) {
  return file.extension() == ".hpp" || file.extension() == ".cpp";
}

/// How many sources below these folders were looked at.
int each_source(std::initializer_list<const char*> folders,
                const std::function<void(const std::string& name, const std::vector<std::string>& lines)>& look) {
  int sources = 0;
  for (const char* folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(KEYBLOCK_SOURCE_DIR) / folder)) {
      if (!is_source(entry.path())) continue;
      ++sources;
      std::ifstream text(entry.path());
      std::vector<std::string> lines;
      for (std::string line; std::getline(text, line);) lines.push_back(line);
      look(entry.path().string(), lines);
    }
  }
  return sources;
}

constexpr int kMostLines = 60;  // of a function, from its head to its closing brace

/// Whether a line at the margin begins a function, as .clang-format lays it out; members stand further in and are
/// shorter than their class.
bool may_begin_function(const std::string& line) {
  constexpr std::array<std::string_view, 9> kOthers{
      "namespace", "struct", "class", "enum", "using", "template", "const ", "constexpr", "inline constexpr"};
  const bool is_at_margin = !line.empty() && (std::isalpha(static_cast<unsigned char>(line.front())) != 0);
  return is_at_margin && line.find('(') != std::string::npos && !line.ends_with(';') &&
         std::ranges::none_of(kOthers, [&](std::string_view word) { return line.starts_with(word); });
}

}  // namespace

TEST(Layout, no_line_of_a_source_is_longer_than_120_characters) {
  const int sources = each_source({"src", "formats", "tests"}, [](const auto& name, const auto& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_LE(characters(lines[i]), kLongest) << name << ":" << i + 1;
  });
  EXPECT_GT(sources, 600);
}

// What a block and a body on covers do differently is said by their groups (step/groups) and by how their points move
// (contact/rows/point_motion).
TEST(Layout, no_line_of_step_and_contact_outside_the_groups_asks_whether_elements_are_on_covers) {
  constexpr std::array<std::string_view, 4> kGroups{"/step/bodies/", "/step/groups/", "/contact/rows/point_motion",
                                                    "/step/linear_stepper"};
  constexpr std::array<std::string_view, 5> kQuestions{"is_on_covers", "reference.covers", "reference_.covers",
                                                       "scene.covers", "CoverScene"};
  int sources = 0;
  each_source({"src/step", "src/contact"}, [&](const auto& name, const auto& lines) {
    const auto is_in = [&](std::string_view part) { return name.find(part) != std::string::npos; };
    if (std::ranges::any_of(kGroups, is_in)) return;
    ++sources;
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const std::string_view question : kQuestions)
        EXPECT_EQ(lines[i].find(question), std::string::npos) << name << ":" << i + 1;
  });
  EXPECT_GT(sources, 60);
}

TEST(Layout, no_function_is_longer_than_60_lines) {
  int functions = 0;
  each_source({"src", "formats"}, [&](const auto& name, const auto& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!may_begin_function(lines[i])) continue;
      std::size_t end = i;
      while (end < lines.size() && lines[end] != "}" && !lines[end].ends_with(" {}")) ++end;
      ++functions;
      EXPECT_LE(end + 1 - i, static_cast<std::size_t>(kMostLines)) << name << ":" << i + 1;
      i = end;
    }
  });
  EXPECT_GT(functions, 1500);
}

}  // namespace keyblock::layout_test
