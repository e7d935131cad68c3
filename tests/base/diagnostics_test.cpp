// The table of diagnostics is in order, complete, and names codes that the program uses.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/words/diagnostics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace keyblock::diagnostics_test {
namespace {

std::string all_sources() {
  std::string text;
  for (const char* room : {"src", "formats"})
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(KEYBLOCK_SOURCE_DIR) / room)) {
      if (entry.path().extension() != ".cpp" || entry.path().filename() == "diagnostics.cpp") continue;
      std::ifstream file(entry.path());
      text.append(std::istreambuf_iterator<char>(file), {});
    }
  return text;
}

TEST(Diagnostics, rows_are_in_the_order_of_their_codes_and_each_is_found) {
  for (std::size_t i = 1; i < diagnostics().size(); ++i)
    EXPECT_LT(diagnostics()[i - 1].code, diagnostics()[i].code);
  for (const Diagnostic& row : diagnostics()) EXPECT_EQ(find_diagnostic(row.code), &row);
  EXPECT_EQ(find_diagnostic("no_such_code"), nullptr);
}

TEST(Diagnostics, every_row_has_its_texts_and_a_code_that_the_program_uses) {
  const std::string sources = all_sources();
  for (const Diagnostic& row : diagnostics()) {
    EXPECT_FALSE(row.summary.empty() || row.summary.size() > 80 || row.summary.ends_with('.')) << row.code;
    EXPECT_TRUE(row.meaning.ends_with('.')) << row.code;
    EXPECT_TRUE(row.remedy.ends_with('.')) << row.code;
    EXPECT_NE(sources.find('"' + std::string(row.code) + '"'), std::string::npos) << row.code;
  }
}

}  // namespace
}  // namespace keyblock::diagnostics_test
