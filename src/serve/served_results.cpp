// Runs `view` and `plot`, and reads records; see served_results.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/served_results.hpp"

#include "base/bytes/file_bytes.hpp"
#include "base/bytes/sound_json.hpp"
#include "serve/request_words.hpp"
#include "serve/run_differences.hpp"

namespace keyblock::serve {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMostRecord = 64U << 20U;  // bytes

}  // namespace

Reply ServedResults::picture(const Parameters& parameters) const {
  const std::string name = parameters.contains("name") ? parameter(parameters, "name") : "picture.svg";
  if (!is_plain_word(name) || !name.ends_with(".svg")) throw BadRequest("expected the name of a picture, NAME.svg");
  const fs::path folder = folder_.whole(parameter(parameters, "result"));
  const fs::path file = folder_.whole(folder_.name(folder / name));
  std::error_code error;
  if (name == "picture.svg" && !fs::exists(file, error)) return drawn(folder);
  return svg_reply(bytes_of(file, kMostText));
}

// Runs without pictures, and those that go on, have none: the last frame is drawn.
Reply ServedResults::drawn(const fs::path& folder) const {
  const fs::path svg = drafts_.file(".svg");
  const Answer answer =
      program_({"plot", as_argument(folder_.name(folder)), "--field", "displacement", "-o", svg.string()});
  std::error_code error;
  if (!fs::is_regular_file(svg, error)) return refusal(404, words_of(answer));
  Reply reply = svg_reply(file_bytes(svg.string()));
  fs::remove(svg, error);
  return reply;
}

Reply ServedResults::page(const std::string& path, const Parameters& parameters) const {
  const std::string command = path == "/page" ? "view" : "report";
  const std::string folder = file_argument(folder_, parameter(parameters, "result"));
  const fs::path file = drafts_.file(".html");
  const Answer answer = program_({command, folder, "-o", file.string()});
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return refusal(422, words_of(answer));
  Reply reply{200, "text/html; charset=utf-8", file_bytes(file.string()), page_headers()};
  fs::remove(file, error);
  return reply;
}

Json ServedResults::record(const Parameters& parameters) const {
  const fs::path folder = folder_.whole(parameter(parameters, "result"));
  std::error_code error;
  const char* name = fs::exists(folder / "fos.json", error) ? "fos.json" : "run.json";
  const Json found = sound_json(bytes_of(folder_.whole(folder_.name(folder / name)), kMostRecord));
  if (!found.is_object()) throw BadRequest("expected the record of a run, found another file");
  return found;
}

Json ServedResults::compare(const Parameters& parameters) const {
  const std::string first = parameter(parameters, "first"), second = parameter(parameters, "second");
  const Json one = record({{"result", first}}), other = record({{"result", second}});
  return {{"first", first},
          {"second", second},
          {"inputs", copies_.differences(one, other)},
          {"differences", run_differences(one, other)}};
}

}  // namespace keyblock::serve
