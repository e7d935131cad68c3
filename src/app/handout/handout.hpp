// Holds what the command `report` writes, and what it says beside.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/document/document.hpp"

namespace keyblock {

struct Handout {
  report::Document document;
  std::vector<std::string> faults;  ///< damage of results, "DIR: error: sentence" per run
};

/// Appends the section unless it is empty.
void add_if_filled(std::vector<report::DocumentSection>& sections, report::DocumentSection section);

/// Makes an anchor of each heading.
void add_anchors(std::vector<report::DocumentSection>& sections);

/// Returns project, program, date of the record in `folder`, and today's date; without a project the first is empty.
std::vector<std::pair<std::string, std::string>> facts_of(const std::string& project, const std::string& program,
                                                          const std::filesystem::path& record);

/// Returns "28 November 2026", today in universal time; SOURCE_DATE_EPOCH (reproducible-builds.org) overrules it.
std::string today();

/// Returns the pictures of the folder that exist and begin as SVG does, each with its caption; at most `most`.
std::vector<report::DocumentPicture> pictures_in(const std::filesystem::path& folder,
                                                 const std::vector<std::pair<std::string, std::string>>& known,
                                                 std::size_t most);

}  // namespace keyblock
