// Locks a shard in a folder of results, so that one process at a time does its jobs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/batch/shard.hpp"

namespace keyblock {

inline constexpr const char* kLockFile = ".lock";

/// Returns true if the folder does not exist, or has nothing but a lock file and the files `own`.
bool is_free(const std::filesystem::path& folder, const std::vector<std::string>& own = {});

/// Lock of one shard, or of all if the shard is the whole. The kernel releases it when the process ends, even if it is
/// killed. An empty file stays in the folder.
class ShardLock {
 public:
  /// Makes the folder. Throws UsageError if that is not possible, and if another process holds the lock for seconds.
  /// File systems without locks are written to without one.
  ShardLock(const std::filesystem::path& folder, const Shard& shard);
  ~ShardLock();
  ShardLock(const ShardLock&) = delete;
  ShardLock& operator=(const ShardLock&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace keyblock
