// Reads the names of DXF layers; the rule is in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_layers.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <limits>
#include <string>
#include <vector>

#include "base/nearest.hpp"

namespace keyblock::formats {
namespace {

struct Word {
  std::string_view text;
  DxfRole role;
};

constexpr std::array<Word, 9> kWords{{
    {"BOUNDARY", DxfRole::boundary},
    {"JOINT", DxfRole::joint},
    {"MATERIAL", DxfRole::material},
    {"BOLT", DxfRole::bolt},
    {"BLOCK", DxfRole::block},
    {"FIXED", DxfRole::fixed},
    {"LOAD", DxfRole::load},
    {"MEASURED", DxfRole::measured},
    {"HOLE", DxfRole::hole},
}};

bool begins_with(std::string_view name, std::string_view word) {
  const auto same = [](char a, char b) { return std::toupper(static_cast<unsigned char>(a)) == b; };
  return name.size() >= word.size() &&
         std::equal(word.begin(), word.end(), name.begin(), [&](char w, char n) { return same(n, w); });
}

/// Returns the digits at the end of a name; with the sign if it follows an underscore, as the writer puts it.
std::string_view last_number(std::string_view name) {
  std::size_t at = name.size();
  while (at > 0 && std::isdigit(static_cast<unsigned char>(name[at - 1])) != 0) --at;
  if (at < name.size() && at >= 2 && name.substr(at - 2, 2) == "_-") --at;
  return name.substr(at);
}

/// Returns the digits after the word, or after a blank, hyphen or underscore that follows it.
std::string_view first_number(std::string_view behind) {
  if (!behind.empty() && std::string_view(" _-").find(behind.front()) != std::string_view::npos)
    behind.remove_prefix(1);
  std::size_t end = 0;
  while (end < behind.size() && std::isdigit(static_cast<unsigned char>(behind[end])) != 0) ++end;
  return behind.substr(0, end);
}

}  // namespace

std::optional<DxfLayer> layer_of(std::string_view name) {
  const auto word = std::ranges::find_if(kWords, [&](const Word& w) { return begins_with(name, w.text); });
  if (word == kWords.end()) return std::nullopt;
  std::string_view digits = last_number(name);
  if (digits.empty()) digits = first_number(name.substr(word->text.size()));
  if (digits.empty()) return DxfLayer{word->role, 0, false};
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || number == std::numeric_limits<int>::min()) return DxfLayer{word->role, 0, true};
  return DxfLayer{word->role, number - 1, false};
}

std::string hint_for_layer(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    if (std::isalpha(static_cast<unsigned char>(c)) == 0) break;
    letters += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  std::vector<std::string> known{"OUTLINE"};
  for (const Word& word : kWords) known.emplace_back(word.text);
  const std::string found = nearest(letters, known);
  return found == "OUTLINE" ? nearest_words("BOUNDARY", {"BOUNDARY"}) : nearest_words(letters, known);
}

bool holds_points_only(DxfRole role) {
  return role == DxfRole::load || role == DxfRole::measured || role == DxfRole::hole;
}

}  // namespace keyblock::formats
