// Contains the built page; see page_html.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/page_html.hpp"

#include <stdexcept>

// KEYBLOCK_RUN_PAGE is the path of the file, given by CMake.
__asm__(
    ".section .rodata\n"
    ".balign 16\n"
    "keyblock_run_page:\n"
    ".incbin \"" KEYBLOCK_RUN_PAGE
    "\"\n"
    "keyblock_run_page_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" {
extern const char keyblock_run_page[] __attribute__((visibility("hidden")));
extern const char keyblock_run_page_end[] __attribute__((visibility("hidden")));
}

namespace keyblock::report {
namespace {

constexpr std::string_view kPlace = "<!--keyblock-data-->";

}  // namespace

std::string_view built_page() {
  return {keyblock_run_page, static_cast<std::size_t>(keyblock_run_page_end - keyblock_run_page)};
}

std::string page_with(const nlohmann::ordered_json& head, const std::vector<PageText>& chunks) {
  const std::string_view page = built_page();
  const std::size_t place = page.find(kPlace);
  if (place == std::string_view::npos) throw std::logic_error("the built page has no place for data");
  std::string text(page.substr(0, place));
  text += "<script type=\"application/json\" id=\"keyblock-head\">";
  for (const char c : head.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  text += "</script>\n";
  for (const auto& [id, chunk] : chunks) {
    text += "<script type=\"text/plain\" id=\"" + id + "\">";
    text += chunk;
    text += "</script>\n";
  }
  text += page.substr(place + kPlace.size());
  return text;
}

}  // namespace keyblock::report
