// One run a folder at a time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <utility>

namespace keyblock {

/// Held while a run writes into its folder. The kernel lets go of it when the process ends, however it ends; nothing is
/// left in the folder.
class FolderLock {
 public:
  FolderLock() = default;

  /// Throws UsageError if another run holds `folder`. File systems that know no locks are written to without one.
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
