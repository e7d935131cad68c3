// Draws files of cases: small for lists, large for the editor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace keyblock::serve {

/// Returns a small picture of the geometry in a file (SVG); empty if the file names its drawing in another file or has
/// no geometry. Throws InputError.
std::string thumbnail_of(const std::filesystem::path& file);

/// Returns a picture of the blocks or of the cover in a file (SVG); empty for other files, such as drawings, which must
/// be cut first. Throws InputError.
std::string blocks_picture_of(const std::filesystem::path& file, bool has_numbers);

}  // namespace keyblock::serve
