// Checks kinds and characters; see request_words.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/request_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "api/named_files.hpp"
#include "base/printable.hpp"
#include "base/words/diagnostics.hpp"
#include "run/follow/history_option.hpp"
#include "serve/window_words.hpp"

namespace keyblock::serve {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostErrors = 200;
constexpr std::size_t kMostSettings = 500;    // more than there are
constexpr std::size_t kMostTexts = 100;       // of a list: files of a case, quantities, values
constexpr std::size_t kLongestText = 10'000;  // bytes of one of them: each is an argument of a process

/// Returns the number that ends a text behind a colon, and cuts both off; -1 if there is none.
int number_cut_off(std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon + 1 == text.size() || text.size() - colon > 9) return -1;
  const std::string digits = text.substr(colon + 1);
  if (!std::ranges::all_of(digits, [](unsigned char c) { return std::isdigit(c) != 0; })) return -1;
  text.resize(colon);
  return std::stoi(digits);
}

Json error_json(std::string place, std::string sentence) {
  sentence = window_words(sentence);
  if (place.starts_with("--")) place = window_words(place);
  const int last = number_cut_off(place);
  const int before = last < 0 ? -1 : number_cut_off(place);
  if (before >= 0) return {{"file", place}, {"line", before}, {"column", last}, {"sentence", sentence}};
  if (last >= 0) return {{"file", place}, {"line", last}, {"sentence", sentence}};
  return {{"file", place}, {"sentence", sentence}};
}

}  // namespace

std::string text(const Json& body, const char* name) {
  const auto found = body.find(name);
  if (found == body.end() || !found->is_string()) throw BadRequest(fmt::format("expected a text in \"{}\"", name));
  return found->get<std::string>();
}

std::vector<std::string> texts(const Json& body, const char* name) {
  const auto found = body.find(name);
  if (found == body.end()) return {};
  if (!found->is_array() || !std::ranges::all_of(*found, [](const Json& item) { return item.is_string(); }))
    throw BadRequest(fmt::format("expected a list of texts in \"{}\"", name));
  const auto is_long = [](const Json& item) { return item.get_ref<const std::string&>().size() > kLongestText; };
  if (found->size() > kMostTexts || std::ranges::any_of(*found, is_long))
    throw BadRequest(fmt::format("expected at most {} texts of {} bytes in \"{}\"", kMostTexts, kLongestText, name));
  return found->get<std::vector<std::string>>();
}

int whole_number(const Json& body, const char* name) {
  constexpr int kMost = 1'000'000'000;
  const auto found = body.find(name);
  if (found == body.end() || !found->is_number_integer() || *found < 1 || *found > kMost)
    throw BadRequest(fmt::format("expected a whole number from 1 in \"{}\"", name));
  return found->get<int>();
}

bool flag(const Json& body, const char* name) {
  const auto found = body.find(name);
  if (found == body.end()) return false;
  if (!found->is_boolean()) throw BadRequest(fmt::format("expected true or false in \"{}\"", name));
  return found->get<bool>();
}

void require_one_of(const Json& body, const char* name, const std::vector<std::string>& words) {
  if (!body.contains(name)) return;
  if (std::ranges::find(words, text(body, name)) == words.end())
    throw BadRequest(fmt::format("expected one of {} in \"{}\"", fmt::join(words, ", "), name));
}

std::vector<std::string> histories_in(const Json& body) {
  std::vector<std::string> histories = texts(body, "histories");
  for (const std::string& history : histories) try {
      history_of(history);
    } catch (const std::invalid_argument& error) {
      throw BadRequest(fmt::format("history {}: {}", history, error.what()));
    }
  return histories;
}

bool is_plain_word(const std::string& word) {
  return !word.empty() && word.size() <= 100 && std::isalnum(static_cast<unsigned char>(word[0])) != 0 &&
         std::ranges::all_of(word,
                             [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.'; });
}

std::string as_argument(const std::string& name) {
  return name.starts_with("-") ? "./" + name : name;
}

std::string file_argument(const ServedFolder& folder, const std::string& path) {
  const std::filesystem::path whole = folder.whole(path);
  std::error_code error;
  if (!std::filesystem::exists(whole, error)) throw NotServed("there is no such file or folder");
  return as_argument(folder.name(whole));
}

void require_served(const ServedFolder& folder, const std::string& case_path, const std::string& key,
                    const std::string& value) {
  const bool is_of_case = key.starts_with('/');
  const bool is_file = names_a_file(key.substr(key.rfind('/') + 1)) || key == "/drawing";
  if (!is_file || value.empty()) return;
  if (!is_of_case) {
    folder.whole(value);
    return;
  }
  std::filesystem::path from = folder.whole(case_path);
  if (!std::filesystem::is_directory(from)) from = from.parent_path();
  folder.whole((std::filesystem::path(folder.name(from)) / value).string());
}

std::vector<std::string> setting_arguments(const ServedFolder& folder, const Json& body) {
  std::vector<std::string> words;
  if (body.contains("profile")) {
    const std::string profile = text(body, "profile");
    if (!is_plain_word(profile)) throw BadRequest("expected the name of a profile");
    words.insert(words.end(), {"--profile", profile});
  }
  const Json set = body.value("set", Json::object());
  if (!set.is_object() || set.size() > kMostSettings) throw BadRequest("expected settings by name in \"set\"");
  for (const auto& [name, value] : set.items()) {
    if (!is_plain_word(name)) throw BadRequest("expected the name of a setting");
    const std::string setting = text(set, name.c_str());
    require_served(folder, {}, name, setting);
    words.insert(words.end(), {"--set", name + "=" + setting});
  }
  return words;
}

Json errors_in(const std::string& messages) {
  Json errors = Json::array();
  std::istringstream lines(valid_utf8(messages));
  for (std::string line; std::getline(lines, line) && errors.size() < kMostErrors;) {
    constexpr std::string_view kMark = ": error: ";
    const std::size_t at = line.find(kMark);
    if (at != std::string::npos) errors.push_back(error_json(line.substr(0, at), line.substr(at + kMark.size())));
  }
  return errors;
}

void add_levels(Json& report) {
  if (report.is_array())
    for (Json& item : report) add_levels(item);
  if (!report.is_object()) return;
  const Json name = report.value("name", Json());
  if (name.is_string() && report.contains("sentence")) {
    report["level"] = word_of(level_of(name.get<std::string>()));
    if (report["sentence"].is_string()) report["sentence"] = window_words(report["sentence"].get<std::string>());
    if (const Diagnostic* row = find_diagnostic(name.get<std::string>()))
      report["remedy"] = window_words(std::string(row->remedy));
    return;
  }
  for (auto& [key, value] : report.items()) add_levels(value);
}

std::vector<std::pair<std::string, std::string>> page_headers() {
  return {{"Content-Security-Policy",
           "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src 'self' data: blob:; "
           "media-src blob:; connect-src 'self'; frame-src 'self'; frame-ancestors 'self'; base-uri 'none'; "
           "form-action 'none'"}};
}

}  // namespace keyblock::serve
