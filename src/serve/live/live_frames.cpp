// Compares the state of a page with that of the folder; see live_frames.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/live/live_frames.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "job/folder/folder_lock.hpp"
#include "job/folder/frame_files.hpp"
#include "job/page/live_coder.hpp"
#include "serve/live/frame_watch.hpp"
#include "serve/request_words.hpp"

namespace keyblock::serve {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFollowed = 16;                // results; each keeps its bodies and its newest frame
constexpr std::chrono::milliseconds kBetweenLooks{250};  // at the lock, of which no event tells
constexpr std::chrono::milliseconds kLongestWait{5000};  // a browser has six connections for all its windows

int step_in(const Parameters& parameters, const char* name) {
  const std::string text = parameter(parameters, name);
  int step = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), step);
  if (error != std::errc() || end != text.data() + text.size() || step < 0)
    throw BadRequest(fmt::format("expected a step in {}", name));
  return step;
}

bool flag_in(const Parameters& parameters, const char* name) {
  const auto found = parameters.find(name);
  return found != parameters.end() && found->second == "1";
}

/// Returns a text that changes with the file; empty without one.
std::string stamp_of(const fs::path& file) {
  struct stat found {};
  if (stat(file.c_str(), &found) != 0) return {};
  return fmt::format("{}-{}-{}", found.st_ino, found.st_mtim.tv_sec, found.st_mtim.tv_nsec);
}

/// Says what a page shows.
struct Shown {
  int step = 0;            ///< of its last frame
  int epoch = 0;           ///< step at which its last epoch began
  std::string stamp;       ///< of the file of its last frame; empty: not known
  bool is_running = true;  ///< as it was told
  bool wants_contacts = false;
};

}  // namespace

/// Result that pages follow. Several threads may ask for its news.
class Followed {
 public:
  Followed(fs::path folder, const std::function<void()>& wake)
      : folder_(std::move(folder)), coder_(folder_), watch_(folder_ / kFrameFolder, wake) {}

  const fs::path& folder() const { return folder_; }

  /// Returns the news for a page, or nothing. Throws NotServed if the folder is gone, InputError for a broken frame.
  std::optional<Reply> news(const Shown& shown) {
    const std::lock_guard lock(mutex_);
    look();
    if (steps_.empty()) return std::nullopt;
    const std::string stamp = stamp_at(shown.step);
    const bool is_other = !shown.stamp.empty() && shown.stamp != stamp;
    if (stamp.empty() || is_other || stamp_at(shown.epoch).empty())
      return json_reply({{"is_running", is_running()}, {"is_anew", true}});
    if (steps_.back() > shown.step) return newest(shown);
    if (!shown.stamp.empty() && is_running_ == shown.is_running) return std::nullopt;
    return json_reply({{"is_running", is_running()}, {"stamp", stamp}});
  }

  bool is_running() const { return is_running_; }

  /// True if the folder was removed; the watch would not see another one of its name.
  bool is_gone() const { return is_gone_; }

 private:
  void look() {
    const bool is_due = Clock::now() - looked_ > kBetweenLooks;
    if (watch_.has_changed()) {
      steps_.clear();
      for (const auto& [step, file] : frames_in(folder_)) steps_.push_back(step);
    }
    if (!is_due) return;
    looked_ = Clock::now();
    is_running_ = is_locked(folder_);
    is_gone_ = !fs::is_directory(folder_);
    if (is_gone_) throw NotServed("the result was removed");
  }

  std::string stamp_at(int step) const { return stamp_of(frame_file(folder_, step)); }

  /// Pages with the same last epoch get the same bytes.
  Reply newest(const Shown& shown) {
    const int step = steps_.back();
    const std::string base = stamp_at(steps_.front()) + " " + stamp_at(shown.epoch);
    if (base != base_) coder_.forget();
    base_ = base;
    const std::string stamp = stamp_at(step);
    const std::string key = fmt::format("{} {} {}", stamp, base, shown.wants_contacts);
    if (key != key_) {
      Json json{{"is_running", is_running()}, {"stamp", stamp}};
      const report::PageUpdate update = coder_.update(step, shown.epoch, shown.wants_contacts);
      json.update(update.head);
      newest_ = json.dump() + "\n" + update.bytes;
      key_ = key;
    }
    return {200, "application/octet-stream", newest_};
  }

  fs::path folder_;
  std::mutex mutex_;
  LiveCoder coder_;
  std::vector<int> steps_;
  Clock::time_point looked_ = {};
  std::atomic<bool> is_gone_ = false;
  std::atomic<bool> is_running_ = false;  ///< read without the lock
  std::string base_;                      ///< stamps of the frames that the coder keeps
  std::string key_;                       ///< of the reply that is kept
  std::string newest_;                    ///< that reply
  FrameWatch watch_;
};

std::shared_ptr<Followed> LiveFrames::followed(const fs::path& folder) {
  const std::lock_guard lock(mutex_);
  std::erase_if(results_, [](const std::shared_ptr<Followed>& own) { return own->is_gone(); });
  const auto known =
      std::ranges::find_if(results_, [&](const std::shared_ptr<Followed>& own) { return own->folder() == folder; });
  if (known != results_.end())
    results_.splice(results_.begin(), results_, known);
  else
    results_.push_front(std::make_shared<Followed>(folder, wake_));
  if (results_.size() > kMostFollowed) results_.pop_back();
  return results_.front();
}

Reply LiveFrames::answer(const Parameters& parameters) {
  const std::string result = parameter(parameters, "result");
  const fs::path folder = folder_.whole(result);
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw NotServed("there is no such result");
  folder_.whole(folder_.name(folder / kFrameFolder));  // may be a link
  const Shown shown{step_in(parameters, "after"), step_in(parameters, "epoch"),
                    parameters.contains("stamp") ? parameter(parameters, "stamp") : std::string(),
                    flag_in(parameters, "running"), flag_in(parameters, "contacts")};
  const std::shared_ptr<Followed> own = followed(folder);
  Reply later;
  later.later = [own, shown, end = Clock::now() + kLongestWait]() -> std::optional<Reply> {
    std::optional<Reply> reply = own->news(shown);
    if (!reply && Clock::now() > end) return json_reply({{"is_running", own->is_running()}});
    return reply;
  };
  return later;
}

}  // namespace keyblock::serve
