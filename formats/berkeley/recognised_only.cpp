// Recognises files by token equations and marks, without reading them; the layouts are in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/recognised_only.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <sstream>
#include <string>

#include "formats/text/tokens.hpp"

namespace keyblock::formats {
namespace {

Recognition recognise_extended(const Source& source) {
  if (!without_bom(source.text).starts_with("#!0xDDA")) return {};
  return {Recognition::Fit::exact, "it begins with #!0xDDA"};
}

Recognition recognise_disk(const Tokens& tokens) {
  const std::span<const double> n = tokens.numbers;
  const auto is_fraction = [](double v) { return v > 0 && v < 1; };
  if (n.size() < 3 || !(n[0] == 0 || n[0] == 1 || n[0] == 2) || !is_fraction(n[1]) || !is_fraction(n[2])) return {};
  return {Recognition::Fit::exact, "it begins with a kind of 0, 1 or 2 and two integration weights between 0 and 1"};
}

constexpr std::array<std::string_view, 11> kAfterBlock{
    "size", "create", "tolerance", "cut", "zone", "gridpoint", "fix", "contact", "property", "mechanical", "history"};
// Together with BLOCK these distinguish UDEC from a text that contains such a word by chance.
constexpr std::array<std::string_view, 20> kUdecCommands{
    "round", "crack", "jset",   "jregion", "split", "tunnel", "voronoi",  "arc",   "property", "prop",
    "bound", "grav",  "insitu", "insit",   "gen",   "change", "boundary", "cycle", "gravity",  "hist"};

std::string lower_word(std::istringstream& line) {
  std::string word;
  line >> word;
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

bool follows_block(const std::string& word) {
  const bool is_number = !word.empty() && (std::isdigit(static_cast<unsigned char>(word[0])) != 0 || word[0] == '-' ||
                                           word[0] == '+' || word[0] == '.' || word[0] == '(');
  return is_number || std::ranges::find(kAfterBlock, word) != kAfterBlock.end();
}

Recognition recognise_udec(const Source& source) {
  constexpr std::size_t kHead = 1 << 16;  // a deck draws its block near its start
  std::istringstream lines{source.text.substr(0, kHead)};
  std::string text;
  int block_line = 0;
  std::string other;
  for (int number = 1; std::getline(lines, text); ++number) {
    std::istringstream line{text};
    const std::string first = lower_word(line);
    if (first == "block" && block_line == 0 && follows_block(lower_word(line))) block_line = number;
    if (other.empty() && std::ranges::find(kUdecCommands, first) != kUdecCommands.end()) other = first;
    if (block_line != 0 && !other.empty())
      return {Recognition::Fit::exact,
              "line " + std::to_string(block_line) + " is a command BLOCK, and others begin with " + other};
  }
  return {};
}

}  // namespace

constinit const Format kDdaExtended{.name = "dda-extended",
                                    .title = "extended DDA file, version 1.5",
                                    .recognise = recognise_extended,
                                    .evidence = "one mark in public source; layout lost",
                                    .sample = "#!0xDDA-v1.5\n"};
constinit const Format kDiskDda{.name = "disk-dda",
                                .title = "parameter file of the disk DDA program",
                                .recognise_numbers = recognise_disk,
                                .evidence = "inferred",
                                .sample = "1 0.25 0.5 100\n"};

constinit const Format kUdecDeck{
    .name = "udec-deck",
    .title = "commands of UDEC (Itasca)",
    .recognise = recognise_udec,
    .evidence = "manuals and public decks; recognised to be named, not read",
    .sample = "round 0.01\nblock 0 0 0 10 10 10 10 0\njset 45 0 20 0 0 0 2 0\nprop mat 1 d 2600 k 5e9 g 3e9\n"};

}  // namespace keyblock::formats
