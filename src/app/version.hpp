// Which program this is.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

/// "keyblock 0.2.0, commit 0123abc, g++ 12.2.0"; the commit is that which was built, with a + where files differed from
/// it, and left out where the sources came without their history.
std::string version_words();

}  // namespace keyblock
