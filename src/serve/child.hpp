// Runs this program as a child process, with its output in files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "job/folder/folder_lock.hpp"

namespace keyblock::serve {

/// Process of this program. It has its own process group, so that Ctrl-C at the terminal does not reach it. It is
/// requested to stop (SIGTERM) if the thread that started it ends.
class Child {
 public:
  /// Starts `keyblock ARGUMENTS…` in `folder`. Throws std::runtime_error if that fails.
  Child(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
        const std::filesystem::path& output, const std::filesystem::path& messages);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  /// Kills the process if it still runs.
  ~Child();

  pid_t process() const { return process_; }
  /// Returns the exit code, 128 + the signal if one ended it; nothing while the process runs.
  std::optional<int> ended();
  void send(int signal) const;

 private:
  pid_t process_ = -1;
  std::optional<int> code_;
};

/// Fresh folder below the system's temporary one, readable by the user alone; removed at the end. Folders that killed
/// servers left behind are removed at the start.
class Drafts {
 public:
  Drafts();
  Drafts(const Drafts&) = delete;
  Drafts& operator=(const Drafts&) = delete;
  ~Drafts();

  const std::filesystem::path& folder() const { return folder_; }
  /// Returns a new name in the folder.
  std::filesystem::path file(const std::string& ending) const;

 private:
  std::filesystem::path folder_;
  FolderLock lock_;  ///< tells other servers that this one lives
};

struct Answer {
  int exit_code = 0;
  bool ran_out_of_time = false;  ///< the program was killed, and left its half-written files behind
  pid_t process = 0;
  std::string output;
  std::string messages;
};

/// Runs this program for a request that waits for its answer.
class Program {
 public:
  /// Children work in `folder`; their output goes by files in `drafts`, to which it refers.
  Program(std::filesystem::path folder, const Drafts& drafts) : folder_(std::move(folder)), drafts_(drafts) {}

  /// Runs the program to its end, or kills it after two minutes, or after `stop`.
  Answer operator()(const std::vector<std::string>& arguments) const;

  void stop() { is_stopping_ = true; }

 private:
  std::filesystem::path folder_;
  const Drafts& drafts_;
  std::atomic<bool> is_stopping_ = false;
};

}  // namespace keyblock::serve
