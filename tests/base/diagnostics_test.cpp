// The table of diagnostics is in order, explains every code of the sources, and keeps the style of its texts.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/words/diagnostics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "base/words/diagnostics_parts.hpp"
#include "tests/support/warning_codes.hpp"

namespace keyblock::diagnostics_test {
namespace {

constexpr std::size_t kLongestSummary = 80;  // characters
constexpr std::size_t kLongestRemedy = 120;
constexpr std::size_t kMostWords = 35;  // of a sentence
constexpr std::size_t kMostSentences = 3;

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::vector<std::string> sentences(std::string_view text) {
  std::vector<std::string> all;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find(". ", from), text.size());
    all.emplace_back(text.substr(from, end - from));
    from = end + 2;
  }
  return all;
}

std::size_t words(const std::string& sentence) {
  std::istringstream text(sentence);
  return static_cast<std::size_t>(
      std::distance(std::istream_iterator<std::string>(text), std::istream_iterator<std::string>()));
}

/// Returns the first word of the text that the style guide excludes; empty if there is none.
std::string excluded_word(std::string_view text) {
  constexpr std::array<std::string_view, 19> kNever{
      "whatever",      "whoever",       "whereto",     "likewise",     "thereof",    "but for",    "for want of",
      "in the mean",   "of today",      "is none",     "is no number", "as of that", "breaks off", "passed over",
      "looks whether", "in the way of", "in place of", "hurt",         "odd"};
  std::string plain = " ";
  for (const char c : text) {
    const auto u = static_cast<unsigned char>(c);
    plain += std::isalnum(u) != 0 ? static_cast<char>(std::tolower(u)) : ' ';
  }
  plain += ' ';
  const auto has = [&](std::string_view word) {
    return plain.find(' ' + std::string(word) + ' ') != std::string::npos;
  };
  for (const std::string_view word : kNever)
    if (has(word)) return std::string(word);
  return has("the one") && has("the other") ? "the one, the other" : "";
}

}  // namespace

TEST(Diagnostics, rows_of_each_part_are_in_the_order_of_their_codes_and_each_is_found) {
  std::size_t count = 0;
  for (const std::span<const Diagnostic> part : diagnostic_rows::parts()) {
    count += part.size();
    for (std::size_t i = 1; i < part.size(); ++i) EXPECT_LT(part[i - 1].code, part[i].code);
  }
  ASSERT_EQ(diagnostics().size(), count);
  for (std::size_t i = 1; i < count; ++i) EXPECT_LT(diagnostics()[i - 1].code, diagnostics()[i].code) << "twice";
  for (const Diagnostic& row : diagnostics()) EXPECT_EQ(find_diagnostic(row.code), &row);
  EXPECT_EQ(find_diagnostic("no_such_code"), nullptr);
}

TEST(Diagnostics, every_code_of_the_sources_has_a_row) {
  const auto codes = support::warning_codes();
  for (const auto& [code, file] : codes)
    EXPECT_NE(find_diagnostic(code), nullptr)
        << code << " of " << file << " has no row in src/base/words/diagnostics_of_*.cpp";
  EXPECT_GT(codes.size(), 175U) << "codes are not found in the sources any more";
}

TEST(Diagnostics, every_row_has_a_code_that_the_program_uses) {
  const auto codes = support::warning_codes();
  const std::string sources = support::source_text();
  for (const Diagnostic& row : diagnostics()) {
    const std::string code(row.code);
    EXPECT_TRUE(codes.contains(code) || sources.find('"' + code + '"') != std::string::npos) << code;
  }
}

TEST(Diagnostics, texts_keep_the_style) {
  for (const Diagnostic& row : diagnostics()) {
    EXPECT_FALSE(row.summary.empty() || row.summary.ends_with('.')) << row.code;
    EXPECT_LE(characters(row.summary), kLongestSummary) << row.code;
    EXPECT_LE(characters(row.remedy), kLongestRemedy) << row.code << ": it is one line of a message";
    EXPECT_LE(sentences(row.meaning).size(), kMostSentences) << row.code;
    for (const std::string_view text : {row.meaning, row.remedy}) EXPECT_TRUE(text.ends_with('.')) << row.code;
    for (const std::string_view text : {row.summary, row.meaning, row.remedy}) {
      EXPECT_EQ(excluded_word(text), "") << row.code;
      for (const std::string& sentence : sentences(text)) EXPECT_LE(words(sentence), kMostWords) << row.code;
    }
  }
}

TEST(Diagnostics, remedies_of_notes_begin_with_nothing) {
  for (const Diagnostic& row : diagnostics()) {
    const bool is_quiet = row.level == DiagnosticLevel::note || row.level == DiagnosticLevel::silent;
    EXPECT_TRUE(!is_quiet || row.remedy.starts_with("Nothing")) << row.code;
  }
}

}  // namespace keyblock::diagnostics_test
