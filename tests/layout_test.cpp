// The layout that every source keeps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
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

/// Returns the number of sources below these folders.
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

/// Returns true if a line at the margin begins a function, as .clang-format lays it out. Members are indented and
/// shorter than their class.
bool may_begin_function(const std::string& line) {
  constexpr std::array<std::string_view, 9> kOthers{
      "namespace", "struct", "class", "enum", "using", "template", "const ", "constexpr", "inline constexpr"};
  const bool is_at_margin = !line.empty() && (std::isalpha(static_cast<unsigned char>(line.front())) != 0);
  return is_at_margin && line.find('(') != std::string::npos && !line.ends_with(';') &&
         std::ranges::none_of(kOthers, [&](std::string_view word) { return line.starts_with(word); });
}

constexpr int kMostLinesOfClass = 250;  // of its body and of the members outside it

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Returns true if the signature that begins in line `i` ends with a semicolon.
bool is_declaration(const std::vector<std::string>& lines, std::size_t i) {
  const auto ends = [](const std::string& line) {
    return line.ends_with('{') || line.ends_with('}') || line.ends_with(';');
  };
  while (i + 1 < lines.size() && !ends(lines[i])) ++i;
  return lines[i].ends_with(';');
}

/// Returns the class or struct whose body begins with this line; empty if none does.
std::string class_begun(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  if (first == std::string::npos || !line.ends_with('{')) return {};
  for (const std::string_view word : {"class KEYBLOCK_API ", "class ", "struct KEYBLOCK_API ", "struct "}) {
    if (!std::string_view(line).substr(first).starts_with(word)) continue;
    const std::size_t from = first + word.size();
    std::size_t to = from;
    while (to < line.size() && (is_word(line[to]) || line[to] == ':')) ++to;
    const std::string name = line.substr(from, to - from);  // Outer::Inner where it stands apart
    return name.substr(name.rfind(':') + 1);
  }
  return {};
}

/// Returns the class of a member that begins with this line at the margin; empty if there is none.
std::string class_of_member(const std::string& line) {
  const std::string_view head = std::string_view(line).substr(0, line.find('('));
  const std::size_t at = head.rfind("::");
  if (at == std::string_view::npos || head.find(' ', at) != std::string_view::npos) return {};
  std::size_t from = at;
  while (from > 0 && is_word(head[from - 1])) --from;
  return std::string(head.substr(from, at - from));
}

struct ClassLines {
  bool is_begun = false;  // its body is there
  std::size_t lines = 0;
};

/// Classes of a unit, which is a header and its source: units may each have a class of one name. The public library is
/// one unit, with its header in another folder.
std::map<std::string, ClassLines> lines_of_classes() {
  std::map<std::string, ClassLines> classes;
  each_source({"include", "src", "formats"}, [&](const auto& name, const auto& lines) {
    const bool is_public = name.find("src/library/") != std::string::npos || name.find("include/") != std::string::npos;
    const std::string unit = (is_public ? "api" : fs::path(name).replace_extension().string()) + ": ";
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool is_member = may_begin_function(lines[i]);
      const std::string found = is_member ? class_of_member(lines[i]) : class_begun(lines[i]);
      if (found.empty()) continue;
      const std::string last = is_member ? "}" : lines[i].substr(0, lines[i].find_first_not_of(' ')) + "};";
      std::size_t end = i;
      while (end < lines.size() && lines[end] != last && !(is_member && lines[end].ends_with(" {}"))) ++end;
      ClassLines& of = classes[unit + found];
      of.is_begun = of.is_begun || !is_member;
      of.lines += end + 1 - i;
      if (is_member) i = end;
    }
  });
  return classes;
}

}  // namespace

TEST(Layout, no_class_is_longer_than_250_lines) {
  std::size_t largest = 0;
  const std::map<std::string, ClassLines> classes = lines_of_classes();
  for (const auto& [name, of] : classes) {
    EXPECT_TRUE(of.is_begun) << name << ": a member stands apart from its class";
    EXPECT_LE(of.lines, static_cast<std::size_t>(kMostLinesOfClass)) << name;
    largest = std::max(largest, of.lines);
  }
  EXPECT_GT(classes.size(), 800U);
  EXPECT_GT(largest, 200U) << "members outside of classes are counted";
}

TEST(Layout, no_line_of_a_source_is_longer_than_120_characters) {
  const int sources = each_source({"src", "formats", "tests"}, [](const auto& name, const auto& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_LE(characters(lines[i]), kLongest) << name << ":" << i + 1;
  });
  EXPECT_GT(sources, 600);
}

// Groups (step/groups) and the motion of points (contact/rows/point_motion) hold all differences between DDA blocks and
// NMM bodies.
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
      if (!may_begin_function(lines[i]) || is_declaration(lines, i)) continue;
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
