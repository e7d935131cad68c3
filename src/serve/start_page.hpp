// Contains the start page of the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace keyblock::serve {

std::string_view start_page();

}  // namespace keyblock::serve
