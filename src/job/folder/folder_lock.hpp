// Locks a folder, so that only one run at a time writes into it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <utility>

namespace keyblock {

/// Returns true if a run holds the lock of `folder`. Without such a folder, or without locks, no run does.
bool is_locked(const std::filesystem::path& folder);

/// Lock of a run on the folder that it writes into. The kernel releases it when the process ends, even if it is killed.
/// Nothing is left in the folder.
class FolderLock {
 public:
  FolderLock() = default;

  /// Throws UsageError if another run has locked `folder`. File systems without locks are written to without one.
  explicit FolderLock(const std::filesystem::path& folder);

  FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FolderLock& operator=(FolderLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int descriptor_ = -1;
};

}  // namespace keyblock
