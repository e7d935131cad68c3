// The files of an archive: where they lie, what each is to a batch, and the counts by which a geometry and an analysis
// fit.
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
  side_file,   ///< what lies beside a case: replay, measured points, motion, expected values
  foreign,     ///< fits no format and is named like something else: a page, a program, a picture
  unreadable,  ///< fits no format, or breaks off before it says what it holds
};

/// By these a geometry and an analysis are seen to belong together.
struct FitCounts {
  bool is_manifold = false;  ///< a cover, or the analysis of the manifold program
  std::size_t block_materials = 0;
  std::size_t joint_materials = 0;
  std::size_t loading_points = 0;

  bool operator==(const FitCounts&) const = default;
};

struct BatchFile {
  std::string path;  ///< below the root, with `/`, its bytes that are no UTF-8 as %XX, % as %25
  FileRole role = FileRole::unreadable;
  std::string format;               ///< name of the format; empty where none fits
  std::optional<FitCounts> counts;  ///< of geometries and analyses that can be read alone
};

/// What lies in an archive and is no file of it.
struct PassedOver {
  std::string path;         ///< as that of a BatchFile
  std::string_view reason;  ///< "hidden", "dead link", …
};

struct FoundFiles {
  std::vector<std::string> files;  ///< paths as those of a BatchFile, sorted
  std::vector<PassedOver> passed_over;
};

/// The regular files at or below `root`; passed over are hidden files and folders, links to folders, dead links,
/// devices and pipes, and folders with the results of other batches. What lies in `left_out` is not even that. Throws
/// InputError where `root` is no folder.
FoundFiles files_below(const std::filesystem::path& root, const std::filesystem::path& left_out);

/// How many for which reason, with the first: "2 × hidden (the first .git), 1 × dead link (x)"; empty for none.
std::string sentence_of(const std::vector<PassedOver>& passed_over);

/// Where a file of the archive lies: the path below `root` with its bytes as the file system has them.
std::filesystem::path place_of(const std::filesystem::path& root, const std::string& path);

/// What a file is, from its content; its name counts only where no format fits, and then a
/// .txt of numbers or a .json with keys of ours is unreadable whatever its name says. `path` is the one below the root.
BatchFile look_at(const formats::Source& source, const std::string& path);

/// Of a geometry or an analysis; nothing for other contents.
std::optional<FitCounts> counts_of(const formats::Content& content);

/// A word for the catalogue.
std::string_view name_of(FileRole role);

}  // namespace keyblock::study
