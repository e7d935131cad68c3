// Surveys the archive of a batch: every file with its checksum, and the resulting jobs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "report/catalogue_page.hpp"
#include "study/batch/batch_pairs.hpp"

namespace keyblock {

/// File of the archive before any job.
struct SeenFile {
  study::BatchFile file;
  report::CatalogueFile record;
  std::string problem;  ///< reason for not reading its content
};

/// Files and jobs of the archive before the jobs begin.
struct FileTree {
  std::map<std::string, SeenFile> files;  ///< by path
  std::vector<study::BatchJob> jobs;
  std::vector<study::PassedOver> passed_over;

  /// Returns the files that a job depends on, including the expected values of a case.
  std::vector<report::CatalogueFile> files_of(const study::BatchJob& job) const;
  /// Returns the reason why a job cannot be checked; empty if it can.
  std::string problem_of(const study::BatchJob& job) const;
};

inline constexpr int kLargestMebibytes = 64;  ///< default

/// Reads every file below `root` except those below `left_out`, and pairs them; returns no jobs if its context is
/// stopped. Files larger than `largest_mebibytes` are not read.
FileTree survey(const std::filesystem::path& root, const std::filesystem::path& left_out, int largest_mebibytes,
                int threads);

}  // namespace keyblock
