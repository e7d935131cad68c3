// Names the sources, the compiler and the command of this process.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace keyblock {

/// Returns the commit of the sources, with a + if sources of the program differed from it when it was built:
/// "0123abc+". Without a history: "unknown".
std::string source_commit();

/// Returns "g++ 12.2.0".
std::string compiler_words();

/// Returns the words of the command line of this process.
std::vector<std::string> words_of_command();

}  // namespace keyblock
