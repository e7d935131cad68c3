// Answers the requests of the browser window; page/SERVER.md lists them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

#include "serve/child.hpp"
#include "serve/http/http.hpp"
#include "serve/jobs.hpp"
#include "serve/live/live_frames.hpp"
#include "serve/served_folder.hpp"
#include "serve/served_results.hpp"
#include "serve/study/input_copies.hpp"
#include "serve/unsaved.hpp"

namespace keyblock::serve {

/// All work on files is done by child processes of this program: a file that harms one of them does not harm the
/// server.
class Service {
 public:
  /// Refers to all three. `wake` is called by other threads when a reply that waits may have come.
  Service(const ServedFolder& folder, const Drafts& drafts, Jobs& jobs, std::function<void()> wake);

  Reply answer(const Request& request);

  /// Ends the commands that requests wait for; jobs go on.
  void stop_waiting() { program_.stop(); }

 private:
  using Json = nlohmann::ordered_json;

  Reply get(const Target& target);
  Reply post(const std::string& path, const Json& body);

  Json read(const Parameters& parameters) const;
  Reply drawing(const Parameters& parameters) const;
  Reply thumbnail(const Parameters& parameters) const;
  Reply printed(const std::vector<std::string>& words) const;

  Json check(const Json& body) const;
  Json save(const Json& body);
  Json run(const Json& body);
  Json resume(const Json& body);
  Json fos(const Json& body);
  Json sweep(const Json& body);
  Json convert(const Json& body) const;
  Json stop(const Json& body);

  std::vector<std::string> case_arguments(const Json& body) const;
  std::string new_result(const Json& body) const;
  void keep_inputs(const Json& body) const;
  Json started(Order order);

  const ServedFolder& folder_;
  const Drafts& drafts_;
  Jobs& jobs_;
  Program program_;
  InputCopies copies_;
  ServedResults results_;
  LiveFrames live_;
  Unsaved unsaved_;
  std::mutex saving_;  ///< held from the check of a file to its replacement
};

}  // namespace keyblock::serve
