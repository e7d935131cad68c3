// Reads parameters and files for replies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "serve/child.hpp"
#include "serve/http/http.hpp"

namespace keyblock::serve {

using Parameters = std::map<std::string, std::string>;

inline constexpr std::uintmax_t kMostText = 16U << 20U;  ///< bytes of a file in the editor

Reply json_reply(const nlohmann::ordered_json& json);

/// Returns a picture. It may come from a foreign folder: no script in it may run.
Reply svg_reply(std::string svg);

/// Throws BadRequest if the parameter is missing.
std::string parameter(const Parameters& parameters, const char* name);

/// Throw NotServed for no file, BadRequest for one that is too long.
void require_file(const std::filesystem::path& file, std::uintmax_t most);
std::string bytes_of(const std::filesystem::path& file, std::uintmax_t most);

/// Returns the messages of a child as one text for the reader.
std::string words_of(const Answer& answer);

}  // namespace keyblock::serve
