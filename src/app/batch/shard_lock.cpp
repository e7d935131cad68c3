// Shard k locks byte k of a file; the whole locks all bytes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/shard_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "base/error.hpp"

namespace keyblock {
namespace {

// The system may need a moment to clear away a process that was killed.
constexpr int kTries = 50;
constexpr auto kBetweenTries = std::chrono::milliseconds(100);

/// Returns false if another process holds the lock.
bool lock(int descriptor, const Shard& shard) {
  struct flock range = {};
  range.l_type = F_WRLCK;
  range.l_whence = SEEK_SET;
  range.l_start = shard.is_whole() ? 0 : shard.k;
  range.l_len = shard.is_whole() ? 0 : 1;  // 0: to the end
  return fcntl(descriptor, F_OFD_SETLK, &range) == 0 || (errno != EAGAIN && errno != EACCES);
}

}  // namespace

bool is_free(const std::filesystem::path& folder, const std::vector<std::string>& own) {
  if (!std::filesystem::exists(folder)) return true;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder)) {
    const auto is_it = [&](const std::string& file) {
      std::error_code missing;
      return std::filesystem::equivalent(entry.path(), file, missing);
    };
    if (entry.path().filename() != kLockFile && std::ranges::none_of(own, is_it)) return false;
  }
  return true;
}

ShardLock::ShardLock(const std::filesystem::path& folder, const Shard& shard) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw UsageError(fmt::format("cannot make the folder {}", folder.string()));
  descriptor_ = open((folder / kLockFile).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    throw UsageError(fmt::format("cannot open {}: {}; it keeps other processes out of the folder",
                                 (folder / kLockFile).string(), std::strerror(errno)));
  for (int i = 0; !lock(descriptor_, shard); ++i) {
    if (i == kTries) {
      close(descriptor_);
      throw UsageError(fmt::format("another process does {} of {}; wait for its end, or give another folder",
                                   shard.is_whole() ? "jobs" : fmt::format("shard {}", shard.k), folder.string()));
    }
    std::this_thread::sleep_for(kBetweenTries);
  }
}

ShardLock::~ShardLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace keyblock
