// Builds contents with one long list of the shortest numbers. Such files need the most memory per byte.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "formats/format.hpp"

namespace keyblock::support {

struct LongContent {
  std::string name;  ///< of the long list
  formats::Content content;
};

/// Returns one content per list, `count` items long.
std::vector<LongContent> long_contents(std::size_t count);

}  // namespace keyblock::support
