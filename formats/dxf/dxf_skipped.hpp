// Counts the entities of a DXF file that are left out, by kind.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace keyblock::formats {

/// Entities left out, by kind, in the order in which the kinds occur.
class DxfSkipped {
 public:
  void add(std::string_view kind, const Place& place);
  void add_all(const DxfSkipped& other);
  /// Returns one warning per kind: its name, count and first place.
  Warnings warnings() const;

 private:
  struct Kind {
    std::string name;
    Place first;
    std::size_t count = 0;
  };
  void add(std::string_view kind, const Place& place, std::size_t count);

  std::vector<Kind> kinds_;
  std::map<std::string, std::size_t, std::less<>> positions_;
};

}  // namespace keyblock::formats
