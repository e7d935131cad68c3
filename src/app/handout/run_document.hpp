// Makes the report of a run, or of a folder of runs, from what runs left there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "report/document.hpp"

namespace keyblock {

/// Returns the report of the run in `folder`: verdict, pictures, results, assumptions, materials, settings, energies,
/// warnings, files. Materials are those of the input files, if these are where the run read them and have not changed.
/// Throws InputError if the folder has no record of a run.
report::Document run_document(const std::filesystem::path& folder);

/// Returns the report of all runs in folders below `folder`: a table, then verdict and picture of each. Throws
/// InputError if there is no run.
report::Document archive_document(const std::filesystem::path& folder);

}  // namespace keyblock
