// Splits a DXF text into groups, sections and records.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "formats/text/numbers.hpp"

namespace keyblock::formats {
namespace {

constexpr int kLeastCode = -5;
constexpr int kGreatestCode = 1071;
constexpr int kExtendedData = 1000;  // codes from here on belong to applications
constexpr int kComment = 999;

/// Line that begins at an offset, and the start of the next one.
struct Line {
  std::string_view text;  ///< without white space at its ends
  std::size_t offset = 0;
  std::size_t next = 0;
};

Line line_at(std::string_view text, std::size_t at) {
  constexpr std::string_view kBlank = " \t\f\v\x1a";
  const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
  const bool is_pair = text.substr(end).starts_with("\r\n");
  std::string_view line = text.substr(at, end - at);
  const std::size_t blanks = std::min(line.find_first_not_of(kBlank), line.size());
  line.remove_prefix(blanks);
  line = line.substr(0, line.find_last_not_of(kBlank) + 1);
  return {line, at + blanks, std::min(end + (is_pair ? 2 : 1), text.size())};
}

std::optional<int> whole(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool is_head(const DxfGroup& group, std::string_view value) {
  return group.code == 0 && group.value == value;
}

std::vector<DxfRecord> records_of(std::span<const DxfGroup> groups) {
  std::vector<DxfRecord> records;
  records.reserve(static_cast<std::size_t>(std::ranges::count(groups, 0, &DxfGroup::code)));
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i].code != 0) continue;
    std::size_t end = i + 1;
    while (end < groups.size() && groups[end].code != 0) ++end;
    records.push_back({groups[i], groups.subspan(i + 1, end - i - 1)});
  }
  return records;
}

}  // namespace

const DxfGroup* DxfRecord::find(int code) const {
  for (const DxfGroup& group : groups) {
    if (group.code >= kExtendedData) return nullptr;
    if (group.code == code) return &group;
  }
  return nullptr;
}

DxfDocument::DxfDocument(const Source& source) : text_(without_bom(source.text)), map_(source.name, text_) {
  split(text_);
  sort_into_sections();
}

void DxfDocument::split(std::string_view text) {
  end_ = text.size();
  const auto lines = std::ranges::count_if(text, [](char c) { return c == '\n' || c == '\r'; });
  groups_.reserve(static_cast<std::size_t>(lines) / 2 + 1);
  std::size_t at = 0;
  while (text.find_first_not_of(" \t\r\n\f\v\x1a", at) != std::string_view::npos) {
    const Line first = line_at(text, at);
    if (!groups_.empty() && is_head(groups_.back(), "EOF")) {
      warnings_.push_back(
          {"trailing_text", map_.place(first.offset), "text behind the end of the DXF file is ignored"});
      return;
    }
    const std::optional<int> code = whole(first.text);
    if (!code || *code < kLeastCode || *code > kGreatestCode)
      throw InputError(map_.place(first.offset),
                       fmt::format("expected a DXF group code (a whole number from {} to {}), found {}", kLeastCode,
                                   kGreatestCode, in_quotes(first.text)));
    if (first.next >= text.size())
      throw InputError(map_.place(text.size()),
                       fmt::format("expected the value of group {}, found end of file", *code));
    const Line second = line_at(text, first.next);
    (*code == kComment ? comments_ : groups_).push_back({*code, second.text});
    at = second.next;
  }
}

void DxfDocument::fail(std::size_t at, std::string_view expected) const {
  if (at >= groups_.size()) throw InputError(map_.place(end_), fmt::format("expected {}, found end of file", expected));
  throw InputError(place(groups_[at]), fmt::format("expected {}, found group {} with {}", expected, groups_[at].code,
                                                   in_quotes(groups_[at].value)));
}

std::size_t DxfDocument::read_section(std::size_t at) {
  if (!is_head(groups_[at], "SECTION")) fail(at, "group 0 with SECTION or EOF");
  if (at + 1 >= groups_.size() || groups_[at + 1].code != 2) fail(at + 1, "the name (group 2) of the section");
  const std::string_view name = groups_[at + 1].value;
  std::size_t end = at + 2;
  while (end < groups_.size() && !is_head(groups_[end], "ENDSEC")) {
    if (is_head(groups_[end], "SECTION") || is_head(groups_[end], "EOF"))
      fail(end, fmt::format("ENDSEC of the section {}", in_quotes(name)));
    ++end;
  }
  if (end == groups_.size()) fail(end, fmt::format("ENDSEC of the section {}", in_quotes(name)));
  const auto inside = std::span<const DxfGroup>(groups_).subspan(at + 2, end - at - 2);
  sections_.push_back({groups_[at], name, inside, records_of(inside)});
  return end + 1;
}

void DxfDocument::sort_into_sections() {
  std::size_t at = 0;
  while (at < groups_.size() && !is_head(groups_[at], "EOF")) at = read_section(at);
  if (at == groups_.size())
    warnings_.push_back(
        {"dxf_without_end", map_.place(end_), "the file ends without EOF; its entities up to there are read"});
}

double DxfDocument::real(const DxfGroup& group, std::string_view name, std::string_view owner) const {
  if (const auto value = parse_real(group.value)) return *value;
  throw InputError(place(group), fmt::format("expected {} (group {}) of {}, found {}", name, group.code, owner,
                                             in_quotes(group.value)));
}

int DxfDocument::integer(const DxfGroup& group, std::string_view name, std::string_view owner) const {
  if (const auto value = whole(group.value)) return *value;
  throw InputError(place(group), fmt::format("expected {} (group {}, a whole number) of {}, found {}", name, group.code,
                                             owner, in_quotes(group.value)));
}

bool opens_as_dxf(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const Line code = line_at(text, at);
    const Line value = line_at(text, code.next);
    const std::optional<int> number = whole(code.text);
    if (number != kComment) return number == 0 && value.text == "SECTION";
    at = value.next;
  }
  return false;
}

}  // namespace keyblock::formats
