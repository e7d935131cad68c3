// Which geometry goes with which analysis: the jobs of an archive, each with the reason of its pairing.
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
  std::string name;                ///< unique: the geometry's path, and its analysis where it has several
  std::vector<std::string> files;  ///< paths below the root, geometry first
  JobKind kind = JobKind::part;
  std::string paired_by;  ///< one sentence
};

/// Whether an analysis that cannot be read alone can be read with that geometry, and fits it.
using FitsTogether = std::function<bool(const BatchFile& geometry, const BatchFile& analysis)>;

/// The jobs, sorted by name; every file is in at least one. In each folder, in this order: one file that holds both;
/// the same name but for the ending (an unreadable file stands in for the part that is missing); names that differ only
/// in a known beginning (cv07 and mf07); the same numbers in the names; the only geometry and the only analysis left;
/// each analysis whose counts of materials and loading points fit one geometry alone; the only geometry of the folder
/// with every analysis that is left. `fits` is asked at most `kMostTrials` times a
/// folder.
std::vector<BatchJob> pair_files(const std::vector<BatchFile>& files, const FitsTogether& fits);

inline constexpr std::size_t kMostTrials = 1000;

}  // namespace keyblock::study
