// Writes one entry per option: name and value on the left, the sentence on the right.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "app/described_options.hpp"

namespace keyblock {
namespace {

constexpr std::size_t kSentenceColumn = 28;
constexpr std::size_t kLineWidth = 100;

std::string left_side(const CLI::Option& option, const DescribedOption& described) {
  const bool is_many = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
  std::string left =
      described.names.empty() ? described.placeholder : fmt::format("{}", fmt::join(described.names, ","));
  if (described.takes_value && (!described.names.empty() || !described.words.empty())) left += " " + described.value;
  return left + (is_many ? "..." : "");
}

}  // namespace

std::string HelpFormat::make_option(const CLI::Option* option, bool /*is_positional*/) const {
  const DescribedOption of_it = described(*option);
  std::string entry = "  " + left_side(*option, of_it);
  std::size_t column = entry.size();
  const auto break_line = [&] {
    entry += "\n" + std::string(kSentenceColumn, ' ');
    column = kSentenceColumn;
  };
  if (column + 2 > kSentenceColumn)
    break_line();
  else
    entry += std::string(kSentenceColumn - column, ' ');
  column = kSentenceColumn;
  std::istringstream words(sentence_of(*option));
  for (std::string word; words >> word;) {
    if (column > kSentenceColumn && column + 1 + word.size() > kLineWidth) break_line();
    if (column > kSentenceColumn) word.insert(0, " ");
    entry += word;
    column += word.size();
  }
  return entry + "\n";
}

}  // namespace keyblock
