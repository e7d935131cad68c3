// Serves HTTP on the loopback interface.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "serve/http/http.hpp"

namespace keyblock::serve {

struct ServerLimits {
  std::size_t connections = 256;  ///< one more closes the oldest that was not let in yet, or is refused with status 503
  std::size_t waiting = 128;      ///< requests whose reply comes later; one more is refused with status 503
  std::size_t body = 16U << 20U;
  std::chrono::milliseconds patience{15000};       ///< for a request to arrive, and for a reply to leave
  std::chrono::milliseconds first_patience{3000};  ///< for the header of the first request on a connection
  std::chrono::milliseconds between_looks{250};    ///< for a reply that comes later
  std::size_t threads = 8;                         ///< that answer; one more carries bytes
};

class HttpServer {
 public:
  /// Answers from the header alone, before the body is read; nothing lets the request in.
  using Guarding = std::function<std::optional<Reply>(const Request&)>;
  using Handler = std::function<Reply(const Request&)>;

  /// Listens on 127.0.0.1; port 0 takes a free one. Throws std::system_error if the port is taken.
  HttpServer(unsigned short port, const ServerLimits& limits);
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;
  ~HttpServer();

  unsigned short port() const;

  /// Answers requests until SIGINT, SIGTERM, SIGHUP or `stop`; then calls `on_stop` and waits for the answers under
  /// way. Several threads call `handler`; if it throws, the reply has status 500.
  void run(Guarding guard, Handler handler, const std::function<void()>& on_stop = {});

  /// Looks for replies that come later at once. May be called by another thread.
  void wake();

  /// May be called by another thread.
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace keyblock::serve
