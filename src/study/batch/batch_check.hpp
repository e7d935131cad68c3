// Checks one job of an archive: whether it can be read and paired, its number of blocks, and its picture.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "formats/case.hpp"
#include "report/catalogue_page.hpp"
#include "study/batch/batch_pairs.hpp"

namespace keyblock::study {

/// Depth of the check of a job.
enum class CheckDepth {
  scene,    ///< read, paired, cut
  outlook,  ///< also prepared as for a run, for its warnings; a refusal is left to the run
  plan,     ///< prepared; fails if a run refuses it
};

/// Returns the row of a job, `files` with their checksums. `profile` as for `keyblock run`; empty: its default. Errors
/// are reported in the row, not thrown; paths in messages are relative to `root`.
report::CatalogueRow check_job(const std::filesystem::path& root, const BatchJob& job,
                               const std::vector<report::CatalogueFile>& files, CheckDepth depth,
                               const std::string& profile);

/// Returns the row of a job that is only named, or that fails before the check.
report::CatalogueRow row_without_check(const BatchJob& job, const std::vector<report::CatalogueFile>& files,
                                       const std::string& outcome, const std::string& message);

/// Returns true if the analysis can be read with that geometry, and the counts of both agree.
bool fit_together(const std::filesystem::path& root, const BatchFile& geometry, const BatchFile& analysis);

}  // namespace keyblock::study
