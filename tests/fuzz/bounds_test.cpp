// No input makes a reader hold more than 20 times its size or run longer than 10 s per megabyte.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "formats/case_file/keyblock_case.hpp"
#include "formats/registry.hpp"
#include "tests/fuzz/exercise.hpp"
#include "tests/fuzz/long_contents.hpp"
#include "tests/fuzz/meter.hpp"
#include "tests/support/mutated.hpp"

namespace keyblock::support {
namespace {

using namespace formats;

constexpr unsigned kSeed = 20010520;
constexpr int kMutationsAReader = 400;
constexpr int kStretchesASample = 6;
constexpr std::size_t kMegabyte = 1000000;
constexpr std::size_t kRecords = 50000;  // half a megabyte of the shortest

class Bounds : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { count_xml(); }
};

using Work = Cost (*)(const Reader&, const std::string&);

void expect_within_limits(const Reader& reader, const std::string& text, const std::string& what,
                          Work work = read_and_check) {
  try {
    const std::string words = excess(work(reader, text), text.size());
    EXPECT_EQ(words, "") << reader.name << ", " << what;
  } catch (const std::exception& error) {
    ADD_FAILURE() << reader.name << ", " << what << ": " << error.what();
  }
}

std::vector<std::string> samples() {
  std::vector<std::string> texts;
  for (const Format* format : all_formats())
    if (const std::string_view sample = format->sample; !sample.empty()) texts.emplace_back(sample);
  return texts;
}

}  // namespace

TEST_F(Bounds, the_meter_counts_what_is_held_and_forgets_what_is_given_back) {
  forget_peak();
  const std::size_t before = bytes_held();
  { const std::vector<char> block(3 * kMegabyte); }
  EXPECT_GE(peak_bytes() - before, 3 * kMegabyte);
  EXPECT_EQ(bytes_held(), before);
  EXPECT_EQ(excess({21 * kMegabyte, 0}, kMegabyte), "");
  EXPECT_NE(excess({22 * kMegabyte, 0}, kMegabyte), "");
  EXPECT_NE(excess({0, 11.5}, kMegabyte), "");
}

TEST_F(Bounds, samples_of_every_format_changed_at_random_are_stood_by_every_reader) {
  std::mt19937 random(kSeed);
  for (const Reader& reader : all_readers())
    for (const std::string& text : samples()) {
      expect_within_limits(reader, text, "a sample", exercise);
      for (int i = 0; i < kMutationsAReader / 10; ++i) {
        const std::string changed = mutated(text, random);
        expect_within_limits(reader, changed, changed, exercise);
      }
    }
}

TEST_F(Bounds, samples_with_a_stretch_repeated_to_a_megabyte_are_stood) {
  std::mt19937 random(kSeed);
  for (const Format* format : all_formats()) {
    const std::string sample(format->sample);
    if (!format->read || sample.empty()) continue;
    for (int i = 0; i < kStretchesASample; ++i) {
      const std::string text = stretched(sample, kMegabyte, random);
      expect_within_limits(find_reader(format->name), text,
                           text.substr(0, 200) + "…" + text.substr(text.size() / 2, 60));
      expect_within_limits(find_reader("anything"), text, text.substr(0, 1000));
    }
  }
}

TEST_F(Bounds, a_megabyte_of_one_short_word_is_stood_by_every_reader) {
  for (const std::string word : {"\n",
                                 "\r",
                                 "1 ",
                                 "1\n",
                                 "0,",
                                 "[",
                                 "{",
                                 "[0,",
                                 "<",
                                 "<a>",
                                 "<a/>",
                                 "a ",
                                 "#",
                                 "#\n",
                                 "\"",
                                 "{\"a\":",
                                 "[[],",
                                 "0\n0\n",
                                 "&",
                                 "measpoint1=[];",
                                 "measpoint1=[1 1 1 1 1 1 1 1 1];"}) {
    std::string text;
    while (text.size() < kMegabyte) text += word;
    for (const Reader& reader : all_readers()) expect_within_limits(reader, text, word);
  }
}

TEST_F(Bounds, a_fault_behind_a_megabyte_of_line_ends_is_told_in_short) {
  const std::string text = "{\"keyblock\": 1," + std::string(kMegabyte, '\n') + "x";
  expect_within_limits(find_reader("keyblock-case"), text, "a fault");
}

TEST_F(Bounds, a_long_list_of_one_record_is_read_within_the_limits_in_every_format_that_holds_it) {
  int cases = 0;
  for (const LongContent& content : long_contents(kRecords))
    for (const Format* format : all_formats()) {
      if (!format->read || !format->write) continue;
      std::string text;
      try {
        text = format->write(content.content);
      } catch (const std::invalid_argument&) {
        continue;
      }
      ++cases;
      expect_within_limits(find_reader(format->name), text, content.name);
    }
  EXPECT_GE(cases, 30);
}

// As another program may write it: only a comma between numbers.
TEST_F(Bounds, a_case_file_without_white_space_is_read_within_the_limits) {
  for (const LongContent& content : long_contents(kRecords)) {
    std::string text = kKeyblockCase.write(content.content);
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
    expect_within_limits(find_reader("keyblock-case"), text, content.name);
  }
}

// Accepted or refused.
TEST_F(Bounds, a_case_file_of_the_shortest_items_is_read_within_the_limits) {
  for (const std::string list :
       {R"("frames":[)", R"("tracks":[)", R"("frames":[{"elements":[)", R"("tracks":[{"rows":[)",
        R"("blocks":{"blocks":[)", R"("blocks":{"blocks":[{"outer":[)", R"("blocks":{"blocks":[{"holes":[)",
        R"("analysis":{"point_loads":[)", R"("analysis":{"block_materials":[)", R"("motion":[)"})
    for (const std::string item : {"{}", "[]", "0", "[[]]"}) {
      std::string text = R"({"keyblock":1,)" + list + item;
      while (text.size() < kMegabyte) text += "," + item;
      const std::ptrdiff_t opened = std::ranges::count(list, '[');
      text += opened == 2 ? "]}]" : "]";
      if (list.find(":{") != std::string::npos) text += "}";
      expect_within_limits(find_reader("keyblock-case"), text + "}", list + item);
    }
}

TEST_F(Bounds, what_fuzzing_once_found_is_stood_by_every_reader) {
  for (const char* folder : {"tests/fuzz/corpus", "tests/malformed/hostile"})
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(KEYBLOCK_SOURCE_DIR) / folder))
      for (const Reader& reader : all_readers())
        expect_within_limits(reader, load(entry.path().string()).text, entry.path().filename().string(), exercise);
}

}  // namespace keyblock::support
