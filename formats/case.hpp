// Reads the files of a case and combines them to one problem.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formats/registry.hpp"
#include "problem/problem.hpp"

namespace keyblock::formats {

/// Result of one file: a reading or an error, and the chosen format, if any.
struct FileReading {
  std::string path;
  std::optional<Choice> choice;
  std::optional<Reading> reading;
  std::optional<InputError> error;
  Source source;  ///< its bytes
};

/// Reads every file, even if others fail; geometry first, because Shi's analysis file needs its counts. Coordinates of
/// a DXF file are converted to the length unit that another file declares. Throws UsageError for `choices` that no
/// drawing has, and if they are for a drawing and no suitable one is given.
std::vector<FileReading> read_files(const std::vector<std::string>& paths, const DrawingChoices& choices = {});

/// Adds the units of a file to those of others. Throws InputError, at `place`, if two declare different units.
void put_units(std::optional<Units>& into, const std::optional<Units>& units, const Place& place);

/// Combines the contents, in any order, to one problem. Throws InputError at a second geometry or a second analysis.
Problem pair(const std::vector<Content>& contents);

/// Returns the names of materials from all files; those of an analysis precede those of a drawing.
MaterialNames names_of(const std::vector<FileReading>& files);

/// Returns the mismatches between geometry and analysis of one content that `check` reports: missing materials, curves
/// without points, points without curves.
Warnings mismatches(const Content& content);

/// Case that is ready for use, and all warnings of the readers and of `check`.
struct Case {
  std::vector<FileReading> files;
  Problem problem;
  Warnings warnings;
};

/// Pairs and checks the files read. Throws the first InputError, also if there is neither geometry nor analysis.
Case case_of(std::vector<FileReading> files);

/// Reads, pairs and checks. Throws the first InputError, also if there is neither geometry nor analysis.
Case load_case(const std::vector<std::string>& paths, const DrawingChoices& choices = {});

}  // namespace keyblock::formats
