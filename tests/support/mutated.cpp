// Damages text at random; the numbers are those of mt19937 itself, so that they are the same everywhere.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/mutated.hpp"

#include <algorithm>

namespace keyblock::support {
namespace {

std::size_t below(std::size_t limit, std::mt19937& random) {
  return static_cast<std::size_t>(random()) % std::max<std::size_t>(limit, 1);
}

}  // namespace

std::string mutated(std::string text, std::mt19937& random) {
  static const std::string kBytes =
      std::string("0123456789.-+eEdD \n\r\t,;#<>/\"'=&!?nai") + std::string("\0\xff\x1a", 3);
  for (std::size_t changes = 1 + below(4, random); changes > 0; --changes) {
    const std::size_t at = below(text.size() + 1, random);
    const char byte = kBytes[below(kBytes.size(), random)];
    switch (below(5, random)) {
      case 0:
        if (at < text.size()) text[at] = byte;
        break;
      case 1:
        text.insert(at, 1, byte);
        break;
      case 2:
        text.erase(at, 1);
        break;
      case 3:
        text.erase(at, below(40, random));
        break;
      default: {
        const std::size_t first = below(text.size(), random);
        text.insert(at, text.substr(first, below(40, random)));
      }
    }
  }
  return text;
}

std::string stretched(const std::string& text, std::size_t size, std::mt19937& random) {
  const std::size_t at = below(text.size(), random);
  const std::string stretch = text.substr(at, 1 + below(40, random));
  std::string longer = text.substr(0, at);
  while (!stretch.empty() && longer.size() + text.size() - at < size) longer += stretch;
  return longer + text.substr(at);
}

}  // namespace keyblock::support
