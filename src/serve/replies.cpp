// Reads parameters and files for replies; see replies.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/replies.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/bytes/file_bytes.hpp"
#include "base/printable.hpp"
#include "serve/request_words.hpp"
#include "serve/served_folder.hpp"
#include "serve/window_words.hpp"

namespace keyblock::serve {

Reply json_reply(const nlohmann::ordered_json& json) {
  return {200, "application/json", json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

std::string parameter(const Parameters& parameters, const char* name) {
  const auto found = parameters.find(name);
  if (found == parameters.end()) throw BadRequest(fmt::format("expected the parameter {}", name));
  return found->second;
}

void require_file(const std::filesystem::path& file, std::uintmax_t most) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) throw NotServed("there is no such file");
  if (std::filesystem::file_size(file, error) > most) throw BadRequest("the file is too long");
}

std::string bytes_of(const std::filesystem::path& file, std::uintmax_t most) {
  require_file(file, most);
  return file_bytes(file.string());
}

Reply svg_reply(std::string svg) {
  return {200,
          "image/svg+xml",
          std::move(svg),
          {{"Content-Security-Policy", "sandbox; default-src 'none'; style-src 'unsafe-inline'; img-src data:"}}};
}

std::string words_of(const Answer& answer) {
  return answer.ran_out_of_time ? std::string("it took too long and was ended")
                                : window_words(valid_utf8(answer.messages));
}

}  // namespace keyblock::serve
