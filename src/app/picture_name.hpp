// Compares names of files with their content: pictures are SVG, and no other file is.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// Throws UsageError if the name of a picture ends in an ending other than .svg: "--svg: expected a name that ends in
/// .svg, found slope.png; …". Empty names, and names without an ending, are accepted.
void require_picture_name(std::string_view option, const std::string& file);

/// Throws UsageError if the name of a table, or of a file of blocks, has the ending of a picture. `picture_option`
/// writes one.
void require_no_picture_name(std::string_view option, const std::string& file, std::string_view picture_option);

}  // namespace keyblock
