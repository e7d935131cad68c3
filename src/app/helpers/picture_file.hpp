// Writes pictures in the format that the ending of their name asks for: SVG, PDF or PNG.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "job/files.hpp"

namespace keyblock {

/// Throws UsageError if the name of a picture has an ending other than .svg, .pdf or .png, or if it is PDF or PNG and
/// rsvg-convert is not installed. Empty names, and names without an ending, are accepted.
void require_picture_name(std::string_view option, const std::string& file);

/// Throws UsageError if the name of a table, or of a file of blocks, has the ending of a picture. `picture_option`
/// writes one.
void require_no_picture_name(std::string_view option, const std::string& file, std::string_view picture_option);

/// Writes a picture given as SVG. `width` [mm] is that of the printed picture; PNG has 300 dots an inch of it, and two
/// dots a unit without it. Throws like `write_output`, and OutputError if the conversion fails.
void write_picture(const std::string& file, std::string svg, Overwrite overwrite,
                   std::optional<double> width = std::nullopt);

}  // namespace keyblock
