// Builds one rectangle for the tests of the terms.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/scenes.hpp"

namespace keyblock::support {

/// 2 × 1 about (11, 20.5).
inline const Blocks kBlock{{rectangle({10, 20}, {12, 21})}, {}, {}, {}, {}, {}};

inline System system_of_one_block() {
  return System({6});
}

}  // namespace keyblock::support
