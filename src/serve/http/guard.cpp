// Checks host, origin, token and cookie; see guard.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/http/guard.hpp"

#include <fmt/format.h>
#include <openssl/rand.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <utility>

namespace keyblock::serve {
namespace {

constexpr std::size_t kTokenBytes = 32;

/// Returns true for `application/json`, with or without parameters behind a semicolon.
bool is_json(const std::string& type) {
  std::string media = type.substr(0, type.find(';'));
  media.resize(media.find_last_not_of(" \t") + 1);
  std::ranges::transform(media, media.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return media == "application/json";
}

}  // namespace

std::string random_token() {
  std::array<unsigned char, kTokenBytes> bytes{};
  if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1)
    throw std::runtime_error("the system gives no random bytes");
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

Guard::Guard(std::string token, unsigned short port)
    : token_(std::move(token)), session_(random_token()), port_(fmt::format("{}", port)) {}

std::string Guard::address() const {
  return fmt::format("http://127.0.0.1:{}/?token={}", port_, token_);
}

bool Guard::is_own_host(const std::string& host) const {
  return host == "127.0.0.1:" + port_ || host == "localhost:" + port_;
}

// Cookies know no ports: the name holds it, so that two servers do not take each other's.
bool Guard::has_cookie(const std::string& cookies) const {
  const std::string name = "keyblock_" + port_ + "=";
  std::size_t at = 0;
  while (at < cookies.size()) {
    const std::size_t end = std::min(cookies.find(';', at), cookies.size());
    const std::size_t first = std::min(cookies.find_first_not_of(' ', at), end);
    const std::string pair = cookies.substr(first, end - first);
    if (pair.starts_with(name) && is_equal_secret(pair.substr(name.size()), session_)) return true;
    at = end + 1;
  }
  return false;
}

std::optional<Reply> Guard::answer(const Request& request) const {
  if (!is_own_host(request.host)) return refusal(403, "the request names another host");
  const bool is_own_origin =
      request.origin == "http://127.0.0.1:" + port_ || request.origin == "http://localhost:" + port_;
  if (!request.origin.empty() && !is_own_origin) return refusal(403, "the request comes from another page");
  if (request.method != "GET" && request.method != "POST") return refusal(405, "expected GET or POST");
  const Target target = target_of(request.target);
  if (const auto given = target.parameters.find("token"); request.method == "GET" && target.path == "/" &&
                                                          given != target.parameters.end() &&
                                                          is_equal_secret(given->second, token_))
    return Reply{303,
                 "text/plain",
                 {},
                 {{"Location", "/"},
                  {"Set-Cookie", fmt::format("keyblock_{}={}; HttpOnly; SameSite=Strict; Path=/", port_, session_)}}};
  if (!has_cookie(request.cookie))
    return refusal(403, "open the address that keyblock serve printed: this one lacks its token");
  if (request.method == "POST" && !is_own_origin) return refusal(403, "the request names no page that it comes from");
  if (request.method == "POST" && !is_json(request.type))
    return refusal(415, "expected a body of type application/json");
  return std::nullopt;
}

}  // namespace keyblock::serve
