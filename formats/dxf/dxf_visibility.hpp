// Layers of a DXF file that are switched off or frozen: what lies on them is not seen in the drawing program.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "formats/dxf/dxf_groups.hpp"
#include "formats/format.hpp"

namespace keyblock::formats {

/// Reads the records LAYER of the section TABLES: group 62 below 0 is off, bit 1 of group 70 is frozen.
class DxfVisibility {
 public:
  /// A layer that the table names is shown. Throws InputError where a flag or a colour is no whole number.
  DxfVisibility(const DxfDocument& document, const LayerTable& shown);

  bool is_hidden(std::string_view layer) const;
  /// A frozen layer of an INSERT hides all of its block, one that is off what takes its layer from the INSERT.
  bool is_frozen(std::string_view layer) const;

 private:
  std::set<std::string> off_;
  std::set<std::string> frozen_;
};

/// Entities left out because they are not seen: counted, with their layers.
struct DxfHidden {
  std::size_t count = 0;
  std::set<std::string> layers = {};
  Place first = {};

  void add(std::string_view layer, const Place& place);
  void add_all(const DxfHidden& other);
  /// One, or none.
  Warnings warnings() const;
};

}  // namespace keyblock::formats
