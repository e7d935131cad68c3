// Contents with one long list of the shortest numbers each: what a format says in the fewest bytes takes the most
// memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "formats/format.hpp"

namespace keyblock::support {

struct LongContent {
  std::string name;  ///< of the list that is long
  formats::Content content;
};

/// One a list, `count` items long.
std::vector<LongContent> long_contents(std::size_t count);

}  // namespace keyblock::support
