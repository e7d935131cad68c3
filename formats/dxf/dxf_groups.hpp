// Reads a DXF text as group codes with values that know their place, and as sections of records.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/format.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {

/// Line with a number and the line below it. Refers to the text.
struct DxfGroup {
  int code = 0;
  std::string_view value;  ///< without white space at its ends
};

/// Entity, table entry, …: its type (the value of group 0) and the groups up to the next group 0.
struct DxfRecord {
  DxfGroup head;
  std::span<const DxfGroup> groups;

  /// Returns the first group with this code that is not extended data.
  const DxfGroup* find(int code) const;
};

/// Records between SECTION and ENDSEC; groups before the first record (HEADER has no others).
struct DxfSection {
  DxfGroup head;
  std::string_view name;
  std::span<const DxfGroup> groups;
  std::vector<DxfRecord> records;
};

/// DXF text split into groups and sections. Refers to the source, which must outlive it.
class DxfDocument {
 public:
  /// Throws InputError if a group code is not a number, or a value or the end of a section is missing.
  explicit DxfDocument(const Source& source);

  const std::vector<DxfSection>& sections() const { return sections_; }
  const std::vector<DxfGroup>& comments() const { return comments_; }  ///< groups 999
  /// Warnings about text after the end of the file, or about a missing end.
  const Warnings& warnings() const { return warnings_; }
  Place place(const DxfGroup& group) const {
    return map_.place(static_cast<std::size_t>(group.value.data() - text_.data()));
  }

  /// Returns the value as a finite number, as a whole number; InputError "expected NAME (group CODE) of OWNER, found
  /// …".
  double real(const DxfGroup& group, std::string_view name, std::string_view owner) const;
  int integer(const DxfGroup& group, std::string_view name, std::string_view owner) const;

 private:
  void split(std::string_view text);
  void sort_into_sections();
  std::size_t read_section(std::size_t at);
  [[noreturn]] void fail(std::size_t at, std::string_view expected) const;

  std::string_view text_;
  TextMap map_;
  std::size_t end_ = 0;
  std::vector<DxfGroup> groups_;
  std::vector<DxfGroup> comments_;
  std::vector<DxfSection> sections_;
  Warnings warnings_;
};

/// Returns true if the first group that is not a comment is 0 SECTION.
bool opens_as_dxf(std::string_view text);

}  // namespace keyblock::formats
