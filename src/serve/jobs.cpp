// Starts waiting jobs and reads their messages; see jobs.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/jobs.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <utility>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "serve/window_words.hpp"

namespace keyblock::serve {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::chrono::milliseconds kPause{50};
constexpr std::chrono::milliseconds kIdlePause{1000};
// Bytes of messages that are read again at each look. A trial of an hour, 107 bytes every 5 s, leaves the last factors.
constexpr std::streamoff kTail = 80'000;

std::string tail_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return {};
  const std::streamoff size = stream.tellg();
  stream.seekg(std::max<std::streamoff>(0, size - kTail));
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Step, number of steps and time left of the last progress line; bracket of the trials so far.
struct Progress {
  int step = 0;
  int steps = 0;
  std::string left;
  std::optional<double> stands, falls;
};

// Reads the lines of a search, such as "F = 1.25: stable".
void put_trials(const std::string& messages, Progress& progress) {
  static const std::regex kTrial("(^|\n)F = ([0-9.e+-]{1,20}): (stable|unstable)");
  for (std::sregex_iterator at(messages.begin(), messages.end(), kTrial), end; at != end; ++at) {
    const std::string number = (*at)[2];
    double factor = 0;
    if (std::from_chars(number.data(), number.data() + number.size(), factor).ec != std::errc()) continue;
    if ((*at)[3] == "stable")
      progress.stands = std::max(progress.stands.value_or(factor), factor);
    else
      progress.falls = std::min(progress.falls.value_or(factor), factor);
  }
}

Progress progress_in(const std::string& messages) {
  static const std::regex kLine("step ([0-9]{1,9})/([0-9]{1,9})[^\n]*");
  static const std::regex kLeft("((about|less than) [^\n]{1,30}) left");
  Progress progress;
  std::string line;
  for (std::sregex_iterator at(messages.begin(), messages.end(), kLine), end; at != end; ++at) {
    progress.step = std::stoi((*at)[1]);
    progress.steps = std::stoi((*at)[2]);
    line = at->str();
  }
  std::smatch left;
  if (std::regex_search(line, left, kLeft)) progress.left = left[1];
  put_trials(messages, progress);
  return progress;
}

}  // namespace

Jobs::Jobs(std::filesystem::path folder, const Drafts& drafts, std::size_t at_once)
    : folder_(std::move(folder)),
      drafts_(drafts),
      at_once_(at_once),
      worker_([this](const std::stop_token& stop) { work(stop); }) {}

Jobs::~Jobs() {
  worker_.request_stop();
  worker_.join();
}

int Jobs::add(Order order) {
  const std::lock_guard lock(mutex_);
  if (is_busy(order.result)) throw UsageError(order.result + " is in use by another run");
  if (jobs_.size() >= kMostJobs) {
    const auto old = std::ranges::find_if(
        jobs_, [](const Job& job) { return job.state == State::ended || job.state == State::stopped; });
    if (old == jobs_.end()) throw UsageError("too many runs wait");
    jobs_.erase(old);
  }
  replace_earlier(order);
  Job& job = jobs_.emplace_back();
  job.id = ++last_id_;
  job.order = std::move(order);
  job.output = drafts_.file(".out");
  job.messages = drafts_.file(".err");
  wakes_.notify_all();
  return job.id;
}

void Jobs::replace_earlier(Order& order) {
  if (order.kind != "resume") return;
  const auto earlier = std::ranges::find_if(jobs_, [&](const Job& job) {
    return job.order.result == order.result && (job.state == State::ended || job.state == State::stopped);
  });
  if (earlier == jobs_.end()) return;
  order.title = earlier->order.title;
  jobs_.erase(earlier);
}

bool Jobs::stop(int id) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(jobs_, id, &Job::id);
  if (found == jobs_.end()) return false;
  if (found->state == State::waits) found->state = State::stopped;
  if (found->state == State::runs) {
    found->is_stopping = true;
    found->child->send(SIGINT);
  }
  return true;
}

bool Jobs::is_busy(const std::string& result) const {
  return std::ranges::any_of(jobs_, [&](const Job& job) {
    return job.order.result == result && (job.state == State::waits || job.state == State::runs);
  });
}

Json Jobs::json_of(const Job& job) const {
  constexpr std::array<const char*, 4> kWords{"waits", "runs", "ended", "stopped"};
  Json json{{"id", job.id},
            {"kind", job.order.kind},
            {"title", job.order.title},
            {"result", job.order.result},
            {"state", kWords[static_cast<std::size_t>(job.state)]},
            {"is_stopping", job.is_stopping}};
  if (job.state == State::waits) return json;
  const std::string messages = tail_of(job.messages);
  const Progress progress = progress_in(messages);
  json["step"] = progress.step;
  json["steps"] = progress.steps;
  json["left"] = progress.left;
  if (progress.stands) json["stands"] = *progress.stands;
  if (progress.falls) json["falls"] = *progress.falls;
  json["seconds"] =
      std::chrono::duration<double>((job.state == State::runs ? Clock::now() : job.finished) - job.begun).count();
  if (job.state == State::runs) return json;
  json["exit_code"] = job.exit_code;
  json["messages"] = window_words(valid_utf8(messages));
  return json;
}

Json Jobs::list() const {
  const std::lock_guard lock(mutex_);
  Json jobs = Json::array();
  for (const Job& job : jobs_) jobs.push_back(json_of(job));
  return jobs;
}

void Jobs::look_after(Job& job) {
  const std::optional<int> code = job.child->ended();
  if (!code) return;
  job.exit_code = *code;
  job.finished = Clock::now();
  job.state = job.is_stopping ? State::stopped : State::ended;
  job.child.reset();
}

bool Jobs::can_start() const {
  const auto running = std::ranges::count(jobs_, State::runs, &Job::state);
  return static_cast<std::size_t>(running) < at_once_ && std::ranges::count(jobs_, State::waits, &Job::state) > 0;
}

void Jobs::start_next() {
  if (!can_start()) return;
  const auto next = std::ranges::find(jobs_, State::waits, &Job::state);
  next->begun = next->finished = Clock::now();
  try {
    next->child = std::make_unique<Child>(next->order.arguments, folder_, next->output, next->messages);
    next->state = State::runs;
  } catch (const std::runtime_error&) {
    next->exit_code = 126;
    next->state = State::ended;
  }
}

void Jobs::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (true) {
    for (Job& job : jobs_)
      if (job.state == State::runs) look_after(job);
    const bool has_running = std::ranges::count(jobs_, State::runs, &Job::state) > 0;
    if (stop.stop_requested()) {
      if (!has_running) return;
      for (Job& job : jobs_)
        if (job.state == State::runs && !std::exchange(job.is_stopping, true)) job.child->send(SIGTERM);
    } else {
      start_next();
    }
    wakes_.wait_for(lock, stop, has_running ? kPause : kIdlePause, [this] { return can_start(); });
    if (stop.stop_requested()) {
      lock.unlock();
      std::this_thread::sleep_for(kPause);
      lock.lock();
    }
  }
}

}  // namespace keyblock::serve
