// Replaces options by regular expressions, the special ones first.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/window_words.hpp"

#include <array>
#include <cctype>
#include <regex>

namespace keyblock::serve {
namespace {

struct Replacement {
  const char* from;
  const char* to;
};

constexpr std::array<Replacement, 9> kReplacements{{
    {"`?keyblock run --resume [^ \n`]+`?", "the button Go on"},
    {"; give another name, or --force to overwrite it", "; give another name"},
    {"--set ([A-Za-z][A-Za-z0-9_.]*)=", "setting $1 = "},
    {"by --set\\b", "in the form Run"},
    {"--set\\b", "setting"},
    {"--reduce\\b", "strength to reduce"},
    {"--(profile|history|contacts|field|over)\\b", "$1"},
    {"--(quiet|verbose|json)\\b", "$1"},
    // Names of files stay, such as --force.json.
    {"(^|[ (\n])--([a-z][a-z-]*[a-z])(?![a-z-]|/|\\.[a-z])", "$1option $2 of the command line"},
}};

}  // namespace

std::string window_words(const std::string& text) {
  static const auto kPatterns = [] {
    std::array<std::regex, kReplacements.size()> made;
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = std::regex(kReplacements[i].from);
    return made;
  }();
  if (text.find("--") == std::string::npos) return text;
  std::string words = text;
  for (std::size_t i = 0; i < kPatterns.size(); ++i)
    words = std::regex_replace(words, kPatterns[i], kReplacements[i].to);
  if (text.starts_with("--") && !words.empty())
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

}  // namespace keyblock::serve
