// Names of files against what is written into them: pictures are SVG, and nothing else is.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// Throws UsageError where the name of a picture to write ends in something but .svg: "--svg: expected a name that ends
/// in .svg, found slope.png; …". Names that are empty, or have no ending, may be.
void require_picture_name(std::string_view option, const std::string& file);

/// Throws UsageError where the name of a table, or of a file of blocks, ends as that of a picture. `picture_option`
/// writes one.
void require_no_picture_name(std::string_view option, const std::string& file, std::string_view picture_option);

}  // namespace keyblock
