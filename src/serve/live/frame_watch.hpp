// Watches the frames of one result folder by inotify.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <thread>

namespace keyblock::serve {

class FrameWatch {
 public:
  /// Calls `wake` in a thread of its own after each change. The folder of the frames need not exist yet.
  FrameWatch(std::filesystem::path frames, std::function<void()> wake);

  /// Returns true if a frame came, went or was replaced since the last call, and at the first call.
  bool has_changed() { return has_changed_.exchange(false); }

 private:
  void work(const std::stop_token& stop);

  std::filesystem::path frames_;
  std::function<void()> wake_;
  std::atomic<bool> has_changed_ = true;
  std::jthread worker_;
};

}  // namespace keyblock::serve
