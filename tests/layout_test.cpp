// The layout that every source keeps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

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

}  // namespace

TEST(Layout, no_line_of_a_source_is_longer_than_120_characters) {
  int sources = 0;
  for (const char* folder : {"src", "formats", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(KEYBLOCK_SOURCE_DIR) / folder)) {
      if (!is_source(entry.path())) continue;
      ++sources;
      std::ifstream text(entry.path());
      std::string line;
      for (int number = 1; std::getline(text, line); ++number)
        EXPECT_LE(characters(line), kLongest) << entry.path().string() << ":" << number;
    }
  }
  EXPECT_GT(sources, 600);
}

}  // namespace keyblock::layout_test
