// Pairs geometries with analyses: the jobs of an archive, each with the reason of its pairing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/batch/batch_files.hpp"

namespace keyblock::study {

enum class JobKind {
  whole,   ///< geometry and analysis: can be run
  part,    ///< one of the two, or unreadable: can be checked
  listed,  ///< neither: only named
};

struct BatchJob {
  std::string name;                ///< unique: the geometry's path, and its analysis if it has several
  std::vector<std::string> files;  ///< paths below the root, geometry first
  JobKind kind = JobKind::part;
  std::string paired_by;  ///< one sentence
};

/// Test whether an analysis that cannot be read alone can be read with that geometry, and fits it.
using FitsTogether = std::function<bool(const BatchFile& geometry, const BatchFile& analysis)>;

/// Returns the jobs, sorted by name; every file is in at least one. The rules apply per folder, in this order:
///   1. One file holds both.
///   2. The names are equal except for the ending; an unreadable file replaces a missing part.
///   3. The names differ only in a known prefix (cv07 and mf07).
///   4. The names contain the same numbers.
///   5. Only one geometry and one analysis are left.
///   6. The counts of materials and loading points of an analysis fit one geometry alone.
///   7. The folder has only one geometry, which goes with every analysis left.
/// `fits` is called at most `kMostTrials` times per folder.
std::vector<BatchJob> pair_files(const std::vector<BatchFile>& files, const FitsTogether& fits);

inline constexpr std::size_t kMostTrials = 1000;

}  // namespace keyblock::study
