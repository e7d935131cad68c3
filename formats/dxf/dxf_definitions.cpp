// Splits the section BLOCKS into definitions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_definitions.hpp"

namespace keyblock::formats {
namespace {

double real_or_zero(const DxfDocument& document, const DxfRecord& record, int code, std::string_view name) {
  const DxfGroup* group = record.find(code);
  return group == nullptr ? 0 : document.real(*group, name, record.head.value);
}

}  // namespace

DxfDefinitions::DxfDefinitions(const DxfDocument& document, const DxfSection* blocks) {
  if (blocks == nullptr) return;
  const std::span<const DxfRecord> records(blocks->records);
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (records[i].head.value != "BLOCK") continue;
    const DxfGroup* name = records[i].find(2);
    std::size_t end = i + 1;
    while (end < records.size() && records[end].head.value != "ENDBLK" && records[end].head.value != "BLOCK") ++end;
    const Point base{real_or_zero(document, records[i], 10, "x of the base point"),
                     real_or_zero(document, records[i], 20, "y of the base point")};
    definitions_.try_emplace(name == nullptr ? std::string_view() : name->value,
                             DxfDefinition{base, records.subspan(i + 1, end - i - 1), nullptr, false,
                                           real_or_zero(document, records[i], 30, "z of the base point")});
    i = end - 1;
  }
}

DxfDefinition* DxfDefinitions::find(std::string_view name) {
  const auto found = definitions_.find(name);
  return found == definitions_.end() ? nullptr : &found->second;
}

DxfSkipped DxfDefinitions::unused(const DxfDocument& document) const {
  DxfSkipped skipped;
  for (const auto& [name, definition] : definitions_)
    if (definition.shapes == nullptr)
      for (const DxfRecord& record : definition.records)
        skipped.add("entity of a block that no INSERT draws", document.place(record.head));
  return skipped;
}

}  // namespace keyblock::formats
