// Checks the members, runs the command on drafts, and reads what it wrote.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/study/study_requests.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/bytes/file_bytes.hpp"
#include "base/bytes/sound_json.hpp"
#include "base/printable.hpp"
#include "serve/replies.hpp"
#include "serve/request_words.hpp"
#include "study/sweep/varied_key.hpp"

namespace keyblock::serve {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMostKeys = 8;

double number_in(const Json& value, const char* name) {
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    throw BadRequest(fmt::format("expected a number in \"{}\"", name));
  return value.get<double>();
}

/// Adds `--name=NUMBER` if the body has the member.
void add_number(std::vector<std::string>& words, const Json& body, const char* name) {
  if (body.contains(name)) words.push_back(fmt::format("--{}={}", name, number_in(body[name], name)));
}

std::string text_and_remove(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  std::string text = file_bytes(file.string());
  fs::remove(file, error);
  return text;
}

/// Runs the command with a picture and a table as drafts.
Json answer_of(const Drafts& drafts, const Program& program, std::vector<std::string> words) {
  const fs::path svg = drafts.file(".svg"), table = drafts.file(".csv");
  words.insert(words.end(), {"--json", "--svg", svg.string(), "-o", table.string()});
  const Answer answer = program(words);
  Json record = sound_json(answer.output);
  return {{"exit_code", answer.exit_code},           {"record", record.is_discarded() ? Json() : std::move(record)},
          {"svg", valid_utf8(text_and_remove(svg))}, {"table", valid_utf8(text_and_remove(table))},
          {"errors", errors_in(answer.messages)},    {"messages", words_of(answer)}};
}

/// Checks KEY=VALUES. Throws BadRequest for another form, NotServed like `require_served`.
void require_served_values(const ServedFolder& folder, const Json& body, const std::string& over) {
  try {
    const study::VariedKey varied = study::varied_key_of(over);
    for (const Json& value : varied.values)
      if (value.is_string()) require_served(folder, texts(body, "paths").front(), varied.key, value);
  } catch (const std::invalid_argument& error) {
    throw BadRequest(error.what());
  }
}

}  // namespace

std::vector<std::string> sweep_arguments(const ServedFolder& folder, const Json& body) {
  const std::vector<std::string> keys = texts(body, "over");
  if (keys.empty() || keys.size() > kMostKeys)
    throw BadRequest(fmt::format("expected 1 to {} keys with their values in \"over\"", kMostKeys));
  std::vector<std::string> words;
  for (const std::string& key : keys) {
    require_served_values(folder, body, key);
    words.push_back("--over=" + key);
  }
  const std::vector<std::string> outputs = texts(body, "out");
  if (std::ranges::any_of(
          outputs, [](const std::string& output) { return output.empty() || output.find(',') != std::string::npos; }))
    throw BadRequest("expected names of results in \"out\"");
  if (!outputs.empty()) words.push_back(fmt::format("--out={}", fmt::join(outputs, ",")));
  if (flag(body, "zip")) words.emplace_back("--zip");
  for (const std::string& history : histories_in(body)) words.push_back("--history=" + history);
  words.insert(words.end(), {"--jobs", "1"});
  return words;
}

Json element_test(const ServedFolder& folder, const Drafts& drafts, const Program& program, const Json& body) {
  require_one_of(body, "kind", {"uniaxial", "triaxial", "biaxial", "oedometer", "shear", "cyclic"});
  std::vector<std::string> words{"element", file_argument(folder, text(body, "path")), "--path", text(body, "kind")};
  const Json targets = body.value("to", Json::array());
  if (!targets.is_array() || targets.empty()) throw BadRequest("expected a list of strains in \"to\"");
  for (const Json& target : targets) words.push_back(fmt::format("--to={}", number_in(target, "to")));
  for (const char* name : {"confining", "size"}) add_number(words, body, name);
  for (const char* name : {"material", "cycles", "steps"})
    if (body.contains(name)) words.push_back(fmt::format("--{}={}", name, whole_number(body, name)));
  return answer_of(drafts, program, std::move(words));
}

Json fitted_curve(const ServedFolder& folder, const Drafts& drafts, const Program& program, const Json& body) {
  require_one_of(body, "kind", {"curve", "triaxial", "chevron_bend", "notched_disc", "semicircular_bend"});
  const std::string kind = text(body, "kind");
  std::vector<std::string> words{"fit", file_argument(folder, text(body, "path"))};
  if (kind == "triaxial")
    words.emplace_back("--triaxial");
  else if (kind != "curve")
    words.push_back("--toughness=" + kind);
  add_number(words, body, "friction");
  return answer_of(drafts, program, std::move(words));
}

}  // namespace keyblock::serve
