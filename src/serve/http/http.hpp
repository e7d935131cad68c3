// Describes one request and its reply, without the library that carries them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace keyblock::serve {

struct Request {
  std::string method;  ///< GET, POST, …
  std::string target;  ///< as it came: "/api/read?path=a%20b"
  std::string host;
  std::string origin;  ///< empty: none
  std::string cookie;
  std::string type;  ///< of the body
  std::string body;
};

struct Reply {
  int status = 200;
  std::string type = "application/json";
  std::string body = {};
  std::vector<std::pair<std::string, std::string>> headers = {};
  /// If set, the reply is what this returns: the server calls it until it returns one.
  std::function<std::optional<Reply>()> later = {};
};

/// Path and parameters of a target, decoded.
struct Target {
  std::string path;
  std::map<std::string, std::string> parameters;
};

/// Decodes a target. Bytes that are no escape stay as they are.
Target target_of(const std::string& text);

/// Returns a reply {"error": sentence}.
Reply refusal(int status, const std::string& sentence);

/// Returns true if both are equal, in a time that does not depend on their bytes.
bool is_equal_secret(const std::string& a, const std::string& b);

}  // namespace keyblock::serve
