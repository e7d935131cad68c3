// Lets in only requests of the browser that was given the printed address.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "serve/http/http.hpp"

namespace keyblock::serve {

/// Returns 32 random bytes as hexadecimal digits. Throws std::runtime_error without a source of random bytes.
std::string random_token();

class Guard {
 public:
  Guard(std::string token, unsigned short port);

  /// Returns the reply to a request that may not go on. It is 403 for another host, a foreign origin or a missing
  /// cookie. It is 405 for another method than GET or POST, and 303 with the cookie for the printed address. POST needs
  /// an own origin and JSON.
  std::optional<Reply> answer(const Request& request) const;

  /// Returns the address to open: "http://127.0.0.1:8123/?token=…".
  std::string address() const;

 private:
  bool is_own_host(const std::string& host) const;
  bool has_cookie(const std::string& cookies) const;

  std::string token_;
  std::string session_;  ///< value of the cookie: the token is of no use afterwards
  std::string port_;
};

}  // namespace keyblock::serve
