// The archive of a batch as found: every file with its checksum, and the jobs they make.
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

/// A file of the archive as seen before any job.
struct SeenFile {
  study::BatchFile file;
  report::CatalogueFile record;
  std::string problem;  ///< why its content was not looked at
};

/// All that is known of the archive before the jobs begin.
struct FileTree {
  std::map<std::string, SeenFile> files;  ///< by path
  std::vector<study::BatchJob> jobs;
  std::vector<study::PassedOver> passed_over;

  /// What a job depends on: its files, and the expected values beside a case.
  std::vector<report::CatalogueFile> files_of(const study::BatchJob& job) const;
  /// Why a job cannot even be looked at; empty where it can.
  std::string problem_of(const study::BatchJob& job) const;
};

inline constexpr int kLargestMebibytes = 64;  ///< unless asked otherwise

/// Looks at every file below `root` but those below `left_out`, and pairs them; without jobs if its context is stopped.
/// Files larger than `largest_mebibytes` are not read.
FileTree survey(const std::filesystem::path& root, const std::filesystem::path& left_out, int largest_mebibytes,
                int threads);

}  // namespace keyblock
