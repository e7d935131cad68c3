// Tells pages of runs that go on about new frames, and about the end of the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <utility>

#include "serve/http/http.hpp"
#include "serve/replies.hpp"
#include "serve/served_folder.hpp"

namespace keyblock::serve {

class Followed;

/// Results that pages follow. All pages of a result share its watch, and the code of its newest frame.
class LiveFrames {
 public:
  /// Refers to the folder. `wake` is called by other threads when a reply that waits may have come.
  LiveFrames(const ServedFolder& folder, std::function<void()> wake) : folder_(folder), wake_(std::move(wake)) {}

  /// Answers /api/live, see page/SERVER.md: when the page does not know the newest state.
  Reply answer(const Parameters& parameters);

 private:
  std::shared_ptr<Followed> followed(const std::filesystem::path& folder);

  const ServedFolder& folder_;
  std::function<void()> wake_;
  std::mutex mutex_;
  std::list<std::shared_ptr<Followed>> results_;  ///< the one asked for last comes first
};

}  // namespace keyblock::serve
