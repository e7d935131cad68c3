// Finds the files of an archive, their roles in a batch, and the counts by which geometry and analysis fit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/format.hpp"

namespace keyblock::study {

enum class FileRole {
  geometry,
  analysis,
  whole_case,  ///< geometry and analysis in one file
  side_file,   ///< additional file of a case: replay, measured points, motion, expected values
  foreign,     ///< fits no format and has the name of another kind: page, program, picture
  unreadable,  ///< fits no format, or ends before its content is known
};

/// Counts that show whether a geometry and an analysis belong together.
struct FitCounts {
  bool is_manifold = false;  ///< a cover, or the analysis of the manifold program
  std::size_t block_materials = 0;
  std::size_t joint_materials = 0;
  std::size_t loading_points = 0;

  bool operator==(const FitCounts&) const = default;
};

struct BatchFile {
  std::string path;  ///< below the root, with `/`; bytes that are not UTF-8 as %XX, % as %25
  FileRole role = FileRole::unreadable;
  std::string format;               ///< name of the format; empty if none fits
  std::optional<FitCounts> counts;  ///< of geometries and analyses that can be read alone
};

/// Entry of an archive that is not one of its files.
struct PassedOver {
  std::string path;         ///< as in BatchFile
  std::string_view reason;  ///< "hidden", "dead link", …
};

struct FoundFiles {
  std::vector<std::string> files;  ///< paths as in BatchFile, sorted
  std::vector<PassedOver> passed_over;
};

/// Returns the regular files at or below `root`. Hidden files and folders, links to folders, dead links, devices, pipes
/// and folders with results of other batches are listed in `passed_over`. `left_out` is ignored entirely. Throws
/// InputError if `root` is not a folder.
FoundFiles files_below(const std::filesystem::path& root, const std::filesystem::path& left_out);

/// Counts the entries per reason, with the first of each: "2 × hidden (the first .git), 1 × dead link (x)"; empty for
/// none.
std::string sentence_of(const std::vector<PassedOver>& passed_over);

/// Returns the place of a file of the archive: the path below `root` with its bytes as in the file system.
std::filesystem::path place_of(const std::filesystem::path& root, const std::string& path);

/// Returns the role of a file from its content. Its name counts only if no format fits. Even then a .txt of numbers, or
/// a .json with case-file keys, is unreadable under any name. `path` is relative to the root.
BatchFile look_at(const formats::Source& source, const std::string& path);

/// Returns the counts of a geometry or an analysis; empty for other contents.
std::optional<FitCounts> counts_of(const formats::Content& content);

/// Returns a word for the catalogue.
std::string_view name_of(FileRole role);

}  // namespace keyblock::study
