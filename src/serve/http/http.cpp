// Decodes targets and makes refusals.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/http/http.hpp"

#include <nlohmann/json.hpp>

namespace keyblock::serve {
namespace {

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string decoded(const std::string& text, bool plus_is_space) {
  std::string found;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = text[i] == '%' && i + 2 < text.size() ? digit_of(text[i + 1]) : -1;
    const int low = high >= 0 ? digit_of(text[i + 2]) : -1;
    if (low >= 0) {
      found += static_cast<char>(16 * high + low);
      i += 2;
    } else {
      found += plus_is_space && text[i] == '+' ? ' ' : text[i];
    }
  }
  return found;
}

}  // namespace

Target target_of(const std::string& text) {
  Target target;
  const std::size_t mark = text.find('?');
  target.path = decoded(text.substr(0, mark), false);
  if (mark == std::string::npos) return target;
  std::size_t at = mark + 1;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('&', at), text.size());
    const std::string pair = text.substr(at, end - at);
    const std::size_t equals = pair.find('=');
    target.parameters[decoded(pair.substr(0, equals), true)] =
        equals == std::string::npos ? std::string() : decoded(pair.substr(equals + 1), true);
    at = end + 1;
  }
  return target;
}

Reply refusal(int status, const std::string& sentence) {
  return {status, "application/json",
          nlohmann::ordered_json({{"error", sentence}}).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

bool is_equal_secret(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
  return difference == 0;
}

}  // namespace keyblock::serve
