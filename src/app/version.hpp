// Names the version of this program.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

/// Returns "keyblock 0.2.0, commit 0123abc, g++ 12.2.0". The commit is that of the build, with a + if files differed
/// from it; "unknown" if the sources had no history.
std::string version_words();

}  // namespace keyblock
