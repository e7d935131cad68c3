// What a batch does with one job: checks it, here or, with limits, in a process; runs or converts it in processes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/batch/child_process.hpp"
#include "report/catalogue_page.hpp"
#include "study/batch/batch_pairs.hpp"

namespace keyblock {

enum class BatchTask { check, run, convert };

struct BatchPlan {
  BatchTask task = BatchTask::check;
  std::filesystem::path root;    ///< the archive
  std::filesystem::path folder;  ///< for the results
  std::string profile;           ///< empty: those of a comparison, legacy and standard; for a check the default
  std::string format;            ///< to convert to
  ChildLimits limits;

  /// Everything that decides over a row beside the files: two batches of one task give the same rows.
  std::string task_text() const;
  /// Where processes that check a job leave what they print, until the batch ends.
  std::filesystem::path checks_folder() const;
};

/// The finished row. Throws OutputError where results cannot be written.
report::CatalogueRow do_job(const BatchPlan& plan, const study::BatchJob& job,
                            const std::vector<report::CatalogueFile>& files);

}  // namespace keyblock
