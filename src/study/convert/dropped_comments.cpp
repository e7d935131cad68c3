// Finds the starts of comments for each kind of format.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/dropped_comments.hpp"

#include <algorithm>
#include <vector>

#include "base/sentences/sentences.hpp"
#include "formats/berkeley/ddaml.hpp"
#include "formats/case_file/keyblock_case.hpp"
#include "formats/text/splitter.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::study {
namespace {

using Offsets = std::vector<std::size_t>;

std::size_t line_end(std::string_view text, std::size_t at) {
  return std::min(text.find_first_of("\r\n", at), text.size());
}

std::size_t behind(std::string_view text, std::string_view mark, std::size_t at) {
  const std::size_t found = text.find(mark, at);
  return found == std::string_view::npos ? text.size() : found + mark.size();
}

// Comments are those of C++, outside of strings.
Offsets in_json(std::string_view text) {
  Offsets starts;
  bool is_string = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\\' && is_string) {
      ++at;
    } else if (text[at] == '"') {
      is_string = !is_string;
    } else if (const std::string_view two = text.substr(at, 2); !is_string && (two == "//" || two == "/*")) {
      starts.push_back(at);
      at = (two == "//" ? line_end(text, at) : behind(text, "*/", at + 2)) - 1;
    }
  }
  return starts;
}

Offsets in_xml(std::string_view text) {
  Offsets starts;
  for (std::size_t at = text.find("<!--"); at < text.size(); at = text.find("<!--", behind(text, "-->", at)))
    starts.push_back(at);
  return starts;
}

Offsets in_numbers(std::string_view text) {
  const formats::Splitter splitter(text, formats::Syntax::native);
  Offsets starts;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (splitter.role_at(at) != formats::Role::comment) continue;
    starts.push_back(at);
    at = line_end(text, at);
  }
  return starts;
}

Offsets comments_in(const formats::Format& format, std::string_view text) {
  if (&format == &formats::kKeyblockCase) return in_json(text);
  if (&format == &formats::kDdaml) return in_xml(text);
  return format.recognise_numbers != nullptr ? in_numbers(text) : Offsets{};
}

}  // namespace

std::optional<Warning> dropped_comments(const formats::FileReading& file) {
  const Offsets starts = comments_in(*file.choice->format, file.source.text);
  if (starts.empty()) return std::nullopt;
  const Facts facts{{{"count", starts.size()}}, {{"comments", starts.size() == 1 ? "comment is" : "comments are"}}};
  return warning_of({"comments_dropped", facts},
                    formats::TextMap(file.source.name, file.source.text).place(starts.front()));
}

}  // namespace keyblock::study
