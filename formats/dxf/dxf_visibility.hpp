// Finds layers of a DXF file that are off or frozen: the drawing program does not show their entities.
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
  /// Shows every layer that the table `shown` names. Throws InputError if a flag or a colour is not a whole number.
  DxfVisibility(const DxfDocument& document, const LayerTable& shown);

  bool is_hidden(std::string_view layer) const;
  /// Returns true for a frozen layer. On an INSERT it hides the whole block; a layer that is off hides only the parts
  /// that take the layer of the INSERT.
  bool is_frozen(std::string_view layer) const;

 private:
  std::set<std::string> off_;
  std::set<std::string> frozen_;
};

/// Entities left out because they are hidden: their number and their layers.
struct DxfHidden {
  std::size_t count = 0;
  std::set<std::string> layers = {};
  Place first = {};

  void add(std::string_view layer, const Place& place);
  void add_all(const DxfHidden& other);
  /// Returns at most one warning.
  Warnings warnings() const;
};

}  // namespace keyblock::formats
