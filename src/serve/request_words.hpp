// Reads members of a request, and makes arguments of this program from them that cannot be taken for options.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "serve/served_folder.hpp"

namespace keyblock::serve {

/// A request with a missing or wrong member.
struct BadRequest : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Return a member of the body. Throw BadRequest if it is missing or of another kind; `texts` returns an empty list
/// for a missing one.
std::string text(const nlohmann::ordered_json& body, const char* name);
std::vector<std::string> texts(const nlohmann::ordered_json& body, const char* name);
int whole_number(const nlohmann::ordered_json& body, const char* name);

/// Returns a member that is true or false; false for a missing one. Throws BadRequest for another kind.
bool flag(const nlohmann::ordered_json& body, const char* name);

/// Throws BadRequest if the member is there and none of the words.
void require_one_of(const nlohmann::ordered_json& body, const char* name, const std::vector<std::string>& words);

/// Returns the histories in the form of `crest=point:12,20`. Throws BadRequest.
std::vector<std::string> histories_in(const nlohmann::ordered_json& body);

/// Returns true for letters, digits, `_`, `-`, `.`, of which the first is a letter or digit.
bool is_plain_word(const std::string& word);

/// Returns the name as a positional argument: "-a.json" becomes "./-a.json".
std::string as_argument(const std::string& name);

/// Returns the argument of a file or folder that exists below the served folder. Throws NotServed.
std::string file_argument(const ServedFolder& folder, const std::string& path);

/// Throws NotServed if the key, a pointer into the case at `case_path` or a setting, names a file, and the value is no
/// path within the folder. A case names files from its own folder on, a setting from the served one.
void require_served(const ServedFolder& folder, const std::string& case_path, const std::string& key,
                    const std::string& value);

/// Returns the arguments of "profile" and "set" (an object of texts). Throws BadRequest, and NotServed like
/// `require_served`.
std::vector<std::string> setting_arguments(const ServedFolder& folder, const nlohmann::ordered_json& body);

/// Returns the errors among messages of the program: file, line, column, sentence; without a place the sentence alone.
nlohmann::ordered_json errors_in(const std::string& messages);

/// Adds `level` (error, warning, note or silent) and `remedy` to each warning of a report, which is an object with a
/// `name` and a `sentence`.
void add_levels(nlohmann::ordered_json& report);

/// Returns the headers of a page of our own: it may load nothing from elsewhere.
std::vector<std::pair<std::string, std::string>> page_headers();

}  // namespace keyblock::serve
