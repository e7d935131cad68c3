// Merges the contents of the files of a case into one, and writes it as a case file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "formats/case.hpp"

namespace keyblock::formats {

/// Adds `content`, of that file, to the content of the files before. Throws InputError for a second geometry, analysis
/// or list of stages, and for different units.
void add_content(Content& all, const Content& content, const std::string& file);

/// Returns true if one of the files is a drawing whose layers were used when it was read.
bool has_used_layers(const std::vector<FileReading>& files);

/// Returns the case as a case file in strict JSON. A single case file keeps its keys, names and units. Of a case file
/// beside other files, the sections that no other file holds keep theirs. Throws the InputError of an unreadable file.
std::string case_file_text(const std::vector<FileReading>& files);

}  // namespace keyblock::formats
