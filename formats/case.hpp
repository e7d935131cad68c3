// The files of a case read and put together to one problem.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formats/registry.hpp"
#include "problem/problem.hpp"

namespace keyblock::formats {

/// What became of one file: a reading or an error, and the format chosen where one could be.
struct FileReading {
  std::string path;
  std::optional<Choice> choice;
  std::optional<Reading> reading;
  std::optional<InputError> error;
  Source source;  ///< its bytes
};

/// Reads every file whatever befalls the others; geometry first, because Shi's analysis file needs its
/// counts. A DXF file is brought to the length unit that another file declares. Throws UsageError where `choices` say
/// something of a drawing, and none is there that it can be said of.
std::vector<FileReading> read_files(const std::vector<std::string>& paths, const DrawingChoices& choices = {});

/// Adds what a file declares to what others did. Throws InputError, at `place`, where two declare different units.
void put_units(std::optional<Units>& into, const std::optional<Units>& units, const Place& place);

/// One problem from the contents, in any order. Throws InputError at a second geometry or a second analysis.
Problem pair(const std::vector<Content>& contents);

/// The names of materials by all files; an analysis names them before a drawing.
MaterialNames names_of(const std::vector<FileReading>& files);

/// What does not fit between geometry and analysis of one content, as `check` says it: materials that are not there,
/// curves without points, points without curves.
Warnings mismatches(const Content& content);

/// A case ready to use and everything odd about it, from the readers and from `check`.
struct Case {
  std::vector<FileReading> files;
  Problem problem;
  Warnings warnings;
};

/// Pairs and checks what was read. Throws the first InputError met, also where there is neither geometry nor analysis.
Case case_of(std::vector<FileReading> files);

/// Reads, pairs and checks. Throws the first InputError met, also where there is neither geometry nor analysis.
Case load_case(const std::vector<std::string>& paths, const DrawingChoices& choices = {});

}  // namespace keyblock::formats
