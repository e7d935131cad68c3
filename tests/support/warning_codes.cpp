// Examines every literal that may be a code, and its enclosing brackets.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/warning_codes.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/sentences/sentences.hpp"

namespace keyblock::support {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFarthest = 200;  // characters from a bracket to a code in it
constexpr std::size_t kLongest = 4000;  // characters of a warning

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \n") + 1 - first);
}

/// Returns the arguments between the bracket at `open` and the one that closes it; empty if it is too far away.
std::vector<std::string_view> arguments_at(std::string_view text, std::size_t open) {
  std::vector<std::string_view> found;
  const std::size_t end = std::min(text.size(), open + kLongest);
  std::size_t start = open + 1;
  int depth = 0;
  char quote = 0;
  for (std::size_t i = open; i < end; ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == '\\') ++i;
      if (c == quote) quote = 0;
    } else if (c == '"' || (c == '\'' && !is_of_word(text[i - 1]))) {
      quote = c;
    } else if (c == '(' || c == '{' || c == '[') {
      ++depth;
    } else if (c == ')' || c == '}' || c == ']') {
      if (--depth > 0) continue;
      found.push_back(trimmed(text.substr(start, i - start)));
      return found;
    } else if (c == ',' && depth == 1) {
      found.push_back(trimmed(text.substr(start, i - start)));
      start = i + 1;
    }
  }
  return {};
}

/// Returns the bracket that encloses a place; empty if it is too far before it.
std::optional<std::size_t> bracket_before(std::string_view text, std::size_t at) {
  int depth = 0;
  for (std::size_t i = at; i > 0 && at - i < kFarthest; --i) {
    const char c = text[i - 1];
    if (c == ';') return std::nullopt;
    if (c == ')' || c == '}' || c == ']') ++depth;
    if ((c == '(' || c == '{' || c == '[') && depth-- == 0) return i - 1;
  }
  return std::nullopt;
}

/// Returns true if the text holds a literal with a blank: a sentence, or part of one.
bool has_words(std::string_view text) {
  for (std::size_t from = text.find('"'); from != std::string_view::npos; from = text.find('"', from + 1)) {
    const std::size_t end = text.find('"', from + 1);
    if (end == std::string_view::npos) return false;
    if (text.substr(from, end - from).find(' ') != std::string_view::npos) return true;
    from = end;
  }
  return false;
}

bool is_sentence(std::string_view argument) {
  constexpr std::array<std::string_view, 5> kNames{"sentence", "sentence)", "unbalanced", "doubt", "kZeroLengthBolt"};
  return has_words(argument) ||
         std::ranges::any_of(kNames, [&](std::string_view name) { return argument.ends_with(name); });
}

/// Name, place and sentence, or a kind of step: name, condition and sentence. A name with a measure is a column.
bool makes_warning(const std::vector<std::string_view>& list) {
  if (list.size() < 3 || list.size() > 4 || list[1].starts_with('"') || list[1].starts_with("m::")) return false;
  return list[2].starts_with('[') || (list.size() == 3 && is_sentence(list[2]));
}

/// A call that makes warnings, by its name and the arguments behind the code.
bool makes_warning(std::string_view function, const std::vector<std::string_view>& all, std::size_t code) {
  if (function.starts_with("warn")) return true;
  constexpr std::array<std::string_view, 4> kOthers{"of_removed", "told", "put", "tell"};
  if (std::ranges::find(kOthers, function) == kOthers.end() || (function == "tell" && all.size() < 3)) return false;
  const bool is_put = function == "put" && all.size() == 2 && all[1].ends_with(')');
  return is_put || std::any_of(all.begin() + static_cast<std::ptrdiff_t>(code) + 1, all.end(), has_words);
}

bool is_code_at(std::string_view text, std::size_t quote, std::string_view code) {
  constexpr std::array<std::string_view, 3> kEndings{"_ignored", "_clamped", "_without_effect"};
  if (std::ranges::any_of(kEndings, [&](std::string_view ending) { return code.ends_with(ending); })) return true;
  const std::optional<std::size_t> open = bracket_before(text, quote);
  if (!open) return false;
  const std::string_view before = trimmed(text.substr(*open + 1, quote - *open - 1));
  const std::vector<std::string_view> all = arguments_at(text, *open);
  if (text[*open] == '{') {
    const bool is_first = before.empty() || before.ends_with('?') || before.ends_with(':');
    return is_first && makes_warning(all);
  }
  const auto commas = static_cast<std::size_t>(std::ranges::count(before, ','));
  if (text[*open] != '(' || commas > 1 || !(before.empty() || before.ends_with(','))) return false;
  std::size_t name = *open;
  while (name > 0 && is_of_word(text[name - 1])) --name;
  return makes_warning(text.substr(name, *open - name), all, commas);
}

/// Calls `look` for every literal of lower-case letters, digits and at least one underscore.
void each_word(std::string_view text, const std::function<void(std::size_t quote, std::string_view word)>& look) {
  for (std::size_t i = text.find('"'); i != std::string_view::npos; i = text.find('"', i + 1)) {
    std::size_t end = i + 1;
    while (end < text.size() && is_of_word(text[end]) && std::isupper(static_cast<unsigned char>(text[end])) == 0)
      ++end;
    const std::string_view word = text.substr(i + 1, end - i - 1);
    const bool is_whole = end < text.size() && text[end] == '"' && !trimmed(text.substr(end + 1, 80)).starts_with('+');
    if (is_whole && word.find('_') != std::string_view::npos) look(i, word);
  }
}

/// Elements of `kDefaults`: their codes are "default_" and the name in lower case.
void add_defaults(const std::string& text, const std::string& file, std::map<std::string, std::string>& codes) {
  const std::size_t begin = text.find("kDefaults{");
  if (begin == std::string::npos) return;
  const std::string_view table = std::string_view(text).substr(begin, text.find(';', begin) - begin);
  for (std::size_t i = table.find("{\""); i != std::string_view::npos; i = table.find("{\"", i + 1)) {
    std::string code = "default_";
    for (std::size_t k = i + 2; k < table.size() && table[k] != '"'; ++k)
      code += static_cast<char>(std::tolower(static_cast<unsigned char>(table[k])));
    codes.emplace(code, file);
  }
}

void each_source(const std::function<void(const std::string& file, const std::string& text)>& look) {
  for (const char* room : {"src", "formats"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(KEYBLOCK_SOURCE_DIR) / room)) {
      if (entry.path().extension() != ".cpp" || entry.path().filename().string().starts_with("diagnostics")) continue;
      std::ifstream file(entry.path());
      look(entry.path().string(), {std::istreambuf_iterator<char>(file), {}});
    }
}

}  // namespace

std::map<std::string, std::string> warning_codes() {
  std::map<std::string, std::string> codes;
  each_source([&](const std::string& file, const std::string& text) {
    each_word(text, [&](std::size_t quote, std::string_view word) {
      if (is_code_at(text, quote, word)) codes.emplace(word, file);
    });
    add_defaults(text, file, codes);
  });
  for (const auto& [table, file] : {std::pair(sentences_ahead(), "sentences_ahead.cpp"),
                                    std::pair(sentences_of_cases(), "sentences_of_cases.cpp"),
                                    std::pair(sentences_of_cuts(), "sentences_of_cuts.cpp"),
                                    std::pair(sentences_of_readers(), "sentences_of_readers.cpp"),
                                    std::pair(sentences_of_runs(), "sentences_of_runs.cpp")})
    for (const Sentence& row : table) codes.emplace(Finding{std::string(row.form)}.code(), file);
  return codes;
}

std::string source_text() {
  std::string all;
  each_source([&](const std::string&, const std::string& text) { all += text; });
  return all;
}

}  // namespace keyblock::support
