// Rewrites sentences that name options of the command line for readers of the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock::serve {

/// Returns the text without options: "--set steps=5" becomes "setting steps = 5", and an option that the window lacks
/// becomes "option NAME of the command line".
std::string window_words(const std::string& text);

}  // namespace keyblock::serve
