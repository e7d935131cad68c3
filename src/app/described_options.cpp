// Reads options from CLI11's own tables; see described_options.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/described_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

namespace keyblock {
namespace {

// CLI11 keeps the words of a check only in the name of the type: "TEXT:{joints,rock,both}".
std::vector<std::string> words_in(std::string_view type) {
  std::vector<std::string> words;
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}', open == std::string_view::npos ? 0 : open);
  if (open == std::string_view::npos || close == std::string_view::npos) return words;
  type = type.substr(open + 1, close - open - 1);
  while (!type.empty()) {
    const std::size_t comma = type.find(',');
    const std::string_view word = type.substr(0, comma);
    words.emplace_back(word.substr(0, word.find("->")));  // of a word that maps to a number
    type = comma == std::string_view::npos ? std::string_view() : type.substr(comma + 1);
  }
  return words;
}

// Parses "INT:INT in [1 - 256]".
std::string range_in(const std::string& type) {
  const std::size_t open = type.find("in [");
  if (open == std::string::npos) return {};
  std::string range = type.substr(open + 4, type.find(']', open) - open - 4);
  const std::size_t dash = range.find(" - ");
  return dash == std::string::npos ? range : range.substr(0, dash) + " to " + range.substr(dash + 3);
}

// Returns the declared type of an option, or its name if CLI11 has only TEXT.
std::string value_of(const DescribedOption& option, const std::string& type) {
  if (!option.words.empty()) return fmt::format("{}", fmt::join(option.words, "|"));
  const std::string kind = type.substr(0, type.find(':'));
  if (kind == "INT" || kind == "UINT") return "N";
  if (kind == "FLOAT") return "NUMBER";
  if (kind != "TEXT" || option.names.empty()) return kind;
  std::string name = option.names.back().substr(option.names.back().find_first_not_of('-'));
  std::ranges::transform(name, name.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c; });
  return name;
}

}  // namespace

DescribedOption described(const CLI::Option& option) {
  DescribedOption found;
  for (const std::string& name : option.get_snames()) found.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) found.names.push_back("--" + name);
  if (found.names.empty()) found.placeholder = option.get_name(true);
  found.description = option.get_description();
  found.takes_value = option.get_items_expected_max() > 0;
  const std::string type = option.get_type_name();
  found.words = words_in(type);
  found.range = range_in(type);
  if (found.takes_value) found.value = value_of(found, type);
  return found;
}

std::string sentence_of(const CLI::Option& option) {
  const DescribedOption of_it = described(option);
  std::string text = of_it.description;
  if (!of_it.range.empty()) text += fmt::format(" [{}]", of_it.range);
  if (const std::string value = option.get_default_str(); !value.empty())
    text += fmt::format(" (default: {})", value.starts_with('[') ? value.substr(1, value.size() - 2) : value);
  if (option.get_required() && !of_it.names.empty()) text += " (required)";
  for (const CLI::Option* needed : option.get_needs()) text += fmt::format(" (with {})", needed->get_name());
  return text;
}

std::vector<DescribedOption> described_options(const CLI::App& app) {
  std::vector<DescribedOption> all;
  for (const CLI::Option* option : app.get_options()) all.push_back(described(*option));
  return all;
}

}  // namespace keyblock
