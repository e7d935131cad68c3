// Runs commands of this program one after another, and reports their progress.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <list>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "serve/child.hpp"

namespace keyblock::serve {

/// Work to do.
struct Order {
  std::string kind;  ///< run, resume, fos
  std::string title;
  std::string result;  ///< result folder, from the served folder on; empty: none
  std::vector<std::string> arguments;
};

inline constexpr std::size_t kMostJobs = 200;  ///< waiting or ended ones that are listed

class Jobs {
 public:
  /// Children work in `folder`; at most `at_once` of them run.
  Jobs(std::filesystem::path folder, const Drafts& drafts, std::size_t at_once);
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;
  /// Requests running jobs to stop and waits for them: a stopped run writes its results.
  ~Jobs();

  /// Returns the number of the job. Throws UsageError if too many wait, or if a job that has not ended writes into the
  /// same result folder.
  int add(Order order);

  /// Requests a job to stop; one that waits is taken from the queue. Returns false if there is no such job.
  bool stop(int id);

  /// Returns all jobs: id, kind, title, result, state (waits, runs, ended, stopped), exit_code, step, steps, left,
  /// messages, seconds.
  nlohmann::ordered_json list() const;

 private:
  enum class State { waits, runs, ended, stopped };
  using Clock = std::chrono::steady_clock;

  struct Job {
    int id = 0;
    Order order;
    State state = State::waits;
    bool is_stopping = false;
    int exit_code = 0;
    std::filesystem::path output, messages;
    Clock::time_point begun = {}, finished = {};
    std::unique_ptr<Child> child = {};
  };

  bool is_busy(const std::string& result) const;
  /// Lets a run that goes on take the place and title of the job that it continues.
  void replace_earlier(Order& order);
  void work(const std::stop_token& stop);
  void look_after(Job& job);
  bool can_start() const;
  void start_next();
  nlohmann::ordered_json json_of(const Job& job) const;

  std::filesystem::path folder_;
  const Drafts& drafts_;
  std::size_t at_once_;
  mutable std::mutex mutex_;
  std::condition_variable_any wakes_;
  std::list<Job> jobs_;
  int last_id_ = 0;
  std::jthread worker_;
};

}  // namespace keyblock::serve
