// Waits for events of the folder; see frame_watch.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/live/frame_watch.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string_view>
#include <utility>

namespace keyblock::serve {
namespace {

constexpr std::uint32_t kEvents = IN_MOVED_TO | IN_MOVED_FROM | IN_CLOSE_WRITE | IN_DELETE | IN_MOVE_SELF | IN_ONLYDIR;
constexpr int kPause = 250;  // ms: a folder that does not exist yet is looked for

/// A frame is whole when the file of its bodies is there.
constexpr std::string_view kLastFile = ".vtu";

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  operator int() const { return number_; }

 private:
  int number_;
};

struct Events {
  bool of_frames = false;
  bool folder_is_gone = false;
};

Events read_events(int descriptor) {
  Events found;
  alignas(inotify_event) std::array<char, 16384> bytes;
  for (ssize_t count = 0; (count = read(descriptor, bytes.data(), bytes.size())) > 0;)
    for (ssize_t at = 0; at < count;) {
      inotify_event event{};
      std::memcpy(&event, bytes.data() + at, sizeof event);
      const std::string_view name = event.len > 0 ? bytes.data() + at + sizeof event : "";
      at += static_cast<ssize_t>(sizeof event + event.len);
      found.folder_is_gone = found.folder_is_gone || (event.mask & (IN_MOVE_SELF | IN_IGNORED)) != 0;
      found.of_frames = found.of_frames || name.empty() || name.ends_with(kLastFile);
    }
  return found;
}

}  // namespace

FrameWatch::FrameWatch(std::filesystem::path frames, std::function<void()> wake)
    : frames_(std::move(frames)),
      wake_(std::move(wake)),
      worker_([this](const std::stop_token& stop) { work(stop); }) {}

void FrameWatch::work(const std::stop_token& stop) {
  const Descriptor events(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)), end(eventfd(0, EFD_CLOEXEC));
  const std::stop_callback on_stop(stop, [&] { eventfd_write(end, 1); });
  int watch = -1;
  while (!stop.stop_requested()) {
    bool is_new = false;
    if (watch < 0) {
      watch = inotify_add_watch(events, frames_.c_str(), kEvents);
      is_new = true;  // without a watch, each pause may hide a change
    }
    const Events found = read_events(events);
    if (found.folder_is_gone && watch >= 0 && !is_new) {
      inotify_rm_watch(events, watch);
      watch = -1;
    }
    if (is_new || found.of_frames) {
      has_changed_ = true;
      wake_();
    }
    std::array<pollfd, 2> waits{{{events, POLLIN, 0}, {end, POLLIN, 0}}};
    poll(waits.data(), waits.size(), kPause);
  }
}

}  // namespace keyblock::serve
