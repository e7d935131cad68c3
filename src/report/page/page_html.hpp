// Puts data into the built page of a run, which the program contains.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace keyblock::report {

/// The page without data, page/built/run.html.
std::string_view built_page();

/// Id and base64 of a chunk.
using PageText = std::pair<std::string, std::string>;

/// Returns the page with its head and its chunks. No text of `head` can end its element.
std::string page_with(const nlohmann::ordered_json& head, const std::vector<PageText>& chunks);

}  // namespace keyblock::report
