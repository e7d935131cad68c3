// Prints a page as PDF by a browser without a window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

/// Returns the name of an installed browser that prints; `CHROMIUM` overrules it. Empty if no browser is found.
std::string printing_browser();

/// Returns the page as PDF on A4. Throws OutputError if the browser fails.
std::string printed_page(const std::string& html, const std::string& browser);

}  // namespace keyblock
