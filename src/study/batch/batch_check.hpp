// Looks at one job of an archive: whether it can be read and put together, how many blocks it has, and how it looks.
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

/// How far a job is followed.
enum class CheckDepth {
  scene,    ///< read, paired, cut
  outlook,  ///< and prepared as for a run, for its warnings; where that is refused, the run says so
  plan,     ///< prepared, and failed where a run refuses it
};

/// The row of a job, `files` with their checksums. `profile` as `keyblock run` takes it; empty: its default. What is
/// wrong is told in the row, not thrown; paths in messages are those below `root`.
report::CatalogueRow check_job(const std::filesystem::path& root, const BatchJob& job,
                               const std::vector<report::CatalogueFile>& files, CheckDepth depth,
                               const std::string& profile);

/// The row of a job that is only named, or that fails before it can be looked at.
report::CatalogueRow row_without_check(const BatchJob& job, const std::vector<report::CatalogueFile>& files,
                                       const std::string& outcome, const std::string& message);

/// Whether the analysis can be read with that geometry, and the counts of both are the same.
bool fit_together(const std::filesystem::path& root, const BatchFile& geometry, const BatchFile& analysis);

}  // namespace keyblock::study
