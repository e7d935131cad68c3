// Reads texts byte by byte; see printable.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/printable.hpp"

#include <fmt/format.h>

namespace keyblock {
namespace {

unsigned char byte(char c) {
  return static_cast<unsigned char>(c);
}

/// Returns the number of bytes of a character with this first byte; 0 if no character begins so.
std::size_t size_by_first(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xc2 || first > 0xf4) return 0;
  return first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
}

/// Returns the number of bytes of the character at the start of the text. Returns 0 without one (RFC 3629: no overlong
/// form, no surrogate).
std::size_t character_size(std::string_view text) {
  const unsigned char first = byte(text[0]);
  const std::size_t size = size_by_first(first);
  if (size < 2 || text.size() < size) return size == 1 ? 1 : 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(text[i]) & 0xc0) != 0x80) return 0;
  const unsigned char second = byte(text[1]);
  const bool is_overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool is_beyond = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return is_overlong || is_beyond ? 0 : size;
}

/// Limit on digits in a row: the shortest decimal of any double has fewer, apart from its zeros.
constexpr std::size_t kMostDigits = 100;

}  // namespace

std::string printable(std::string_view text) {
  std::string safe;
  std::size_t digits = 0;  // in a row
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned char c = byte(text[i]);
    digits = c >= '0' && c <= '9' ? digits + 1 : 0;
    if (digits > kMostDigits) {
      if (digits == kMostDigits + 1) safe += "…";
      continue;
    }
    const bool is_second_control =
        c == 0xc2 && i + 1 < text.size() && byte(text[i + 1]) >= 0x80 && byte(text[i + 1]) < 0xa0;
    if (is_second_control) {
      safe += fmt::format("\\x{:02x}", byte(text[++i]));
    } else if (c < 0x20 || c == 0x7f) {
      safe += fmt::format("\\x{:02x}", c);
    } else {
      safe += text[i];
    }
  }
  return safe;
}

std::string valid_utf8(std::string_view text) {
  std::string valid;
  while (!text.empty()) {
    const std::size_t size = character_size(text);
    if (size == 0)
      valid += "\xef\xbf\xbd";
    else
      valid += text.substr(0, size);
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return valid;
}

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string escape_xml(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  for (char c : valid_utf8(text)) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        // Other control characters may not stand in XML 1.0 at all.
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\t' || c == '\n') safe += c;
    }
  }
  return safe;
}

}  // namespace keyblock
