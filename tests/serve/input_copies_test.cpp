// Copies of input files name the values that changed since a run; their total size is limited.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/study/input_copies.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/bytes/sha256.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::input_copies_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json record_of(const std::string& file, const std::string& text) {
  return {{"inputs", {{{"file", file}, {"sha256", sha256(text)}}}}};
}

std::uintmax_t bytes_in(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) bytes += entry.file_size();
  return bytes;
}

}  // namespace

TEST(InputCopies, the_oldest_are_dropped_beyond_the_limit) {
  constexpr std::uintmax_t kLimit = 2500;
  const fs::path folder = support::fresh_folder("input_copies");
  const serve::ServedFolder served(folder);
  const serve::Drafts drafts;
  const serve::InputCopies copies(served, drafts, kLimit);
  const fs::path file = folder / "case.json";
  const auto text = [](int i) { return std::string("{\"a\": ") + std::to_string(i) + "}" + std::string(993, ' '); };
  for (int i = 1; i <= 4; ++i) {
    support::write_text(file, text(i));
    copies.keep(file);
    EXPECT_LE(bytes_in(drafts.folder() / "inputs"), kLimit);
  }
  const Json kept = copies.differences(record_of("case.json", text(3)), record_of("case.json", text(4)));
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].at("first"), 3);
  EXPECT_EQ(kept[0].at("second"), 4);
  const Json dropped = copies.differences(record_of("case.json", text(1)), record_of("case.json", text(4)));
  ASSERT_EQ(dropped.size(), 1U);
  EXPECT_EQ(dropped[0].at("first"), "case.json (moved or changed since)");
}

// A single file above the limit is kept, for the comparison that follows.
TEST(InputCopies, the_newest_is_kept_in_any_case) {
  const fs::path folder = support::fresh_folder("input_copies");
  const serve::ServedFolder served(folder);
  const serve::Drafts drafts;
  const serve::InputCopies copies(served, drafts, 10);
  support::write_text(folder / "case.json", std::string(100, ' '));
  copies.keep(folder / "case.json");
  EXPECT_EQ(bytes_in(drafts.folder() / "inputs"), 100U);
}

}  // namespace keyblock::input_copies_test
