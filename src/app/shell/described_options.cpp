// Takes options out of CLI11's own tables; see described_options.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/shell/described_options.hpp"

#include <string_view>

namespace keyblock {
namespace {

// CLI11 keeps the words of a check in the name of the type alone: "TEXT:{joints,rock,both}".
std::vector<std::string> words_in(std::string_view type) {
  std::vector<std::string> words;
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}', open == std::string_view::npos ? 0 : open);
  if (open == std::string_view::npos || close == std::string_view::npos) return words;
  type = type.substr(open + 1, close - open - 1);
  while (!type.empty()) {
    const std::size_t comma = type.find(',');
    const std::string_view word = type.substr(0, comma);
    words.emplace_back(word.substr(0, word.find("->")));  // of a word for a number
    type = comma == std::string_view::npos ? std::string_view() : type.substr(comma + 1);
  }
  return words;
}

}  // namespace

std::vector<DescribedOption> described_options(const CLI::App& app) {
  std::vector<DescribedOption> described;
  for (const CLI::Option* option : app.get_options()) {
    DescribedOption& found = described.emplace_back();
    for (const std::string& name : option->get_snames()) found.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) found.names.push_back("--" + name);
    if (found.names.empty()) found.placeholder = option->get_name(true);
    found.description = option->get_description();
    found.takes_value = option->get_items_expected_max() > 0;
    found.words = words_in(option->get_type_name());
  }
  return described;
}

}  // namespace keyblock
