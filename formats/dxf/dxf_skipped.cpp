// Lists the kinds of entities that are left out of a DXF file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_skipped.hpp"

#include "base/sentences/sentences.hpp"

namespace keyblock::formats {

void DxfSkipped::add(std::string_view kind, const Place& place) {
  add(kind, place, 1);
}

void DxfSkipped::add_all(const DxfSkipped& other) {
  for (const Kind& kind : other.kinds_) add(kind.name, kind.first, kind.count);
}

void DxfSkipped::add(std::string_view kind, const Place& place, std::size_t count) {
  const auto found = positions_.find(kind);
  if (found != positions_.end()) {
    kinds_[found->second].count += count;
  } else {
    positions_.emplace(kind, kinds_.size());
    kinds_.push_back({std::string(kind), place, count});
  }
}

Warnings DxfSkipped::warnings() const {
  Warnings all;
  for (const Kind& kind : kinds_) {
    Facts facts{{{"count", kind.count}}};
    facts.names = {{"entity", kind.name}};
    all.push_back(warning_of({"dxf_skipped", std::move(facts)}, kind.first));
  }
  return all;
}

}  // namespace keyblock::formats
