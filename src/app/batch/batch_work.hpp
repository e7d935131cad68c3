// Performs one job of a batch: checks it, here or in a process with limits; runs or converts it in processes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/batch/child_process.hpp"
#include "base/context.hpp"
#include "report/catalogue_page.hpp"
#include "study/batch/batch_pairs.hpp"

namespace keyblock {

enum class BatchTask { check, run, convert };

struct BatchPlan {
  BatchTask task = BatchTask::check;
  std::filesystem::path root;    ///< the archive
  std::filesystem::path folder;  ///< for results
  std::string profile;           ///< empty: legacy and standard for a comparison, the default for a check
  std::string format;            ///< target of a conversion
  ChildLimits limits;
  bool is_resumed = false;           ///< runs that were left unfinished go on from their checkpoints
  std::optional<Context> stop = {};  ///< stops jobs that have begun; nothing: they finish

  /// Returns all choices that determine a row apart from the files: two batches of one task give the same rows.
  std::string task_text() const;
  /// Returns the folder for the output of checking processes, until the batch ends.
  std::filesystem::path checks_folder() const;
};

/// Returns the finished row; nothing if the job was stopped. Throws OutputError if results cannot be written.
std::optional<report::CatalogueRow> do_job(const BatchPlan& plan, const study::BatchJob& job,
                                           const std::vector<report::CatalogueFile>& files);

}  // namespace keyblock
