// Puts data into the built page of a run, which the program contains.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace keyblock::report {

/// The page without data, page/built/run.html.
std::string_view built_page();

/// Returns the page with its head and the elements of its chunks. No text of `head` can end its element.
std::string page_with(const nlohmann::ordered_json& head, std::string_view chunks);

}  // namespace keyblock::report
