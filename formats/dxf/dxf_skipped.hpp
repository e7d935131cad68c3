// What of a DXF file is left out, counted by kind.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace keyblock::formats {

/// Entities left out, by kind, in the order in which the kinds are met.
class DxfSkipped {
 public:
  void add(std::string_view kind, const Place& place);
  void add_all(const DxfSkipped& other);
  /// One a kind: its name, how many, the first place.
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
