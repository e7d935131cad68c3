// Names that files give, in messages.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

/// ` "crown"`, to stand behind a noun; nothing where there is no name.
inline std::string quoted_name(const std::string& name) {
  return name.empty() ? std::string() : " \"" + name + '"';
}

}  // namespace keyblock
