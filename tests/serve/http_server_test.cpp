// A slow client is cut off, and does not delay others.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/http/http_server.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <thread>

namespace keyblock::http_server_test {
namespace {

using Clock = std::chrono::steady_clock;
using serve::HttpServer;
using serve::Reply;
using serve::Request;

class Client {
 public:
  explicit Client(unsigned short port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in there{};
    there.sin_family = AF_INET;
    there.sin_port = htons(port);
    there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(socket_, reinterpret_cast<const sockaddr*>(&there), sizeof there), 0);
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  ~Client() { close(socket_); }

  void send(const std::string& text) const { ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL); }
  /// All bytes until the server closes.
  std::string rest() const {
    std::string text;
    char part[4096];
    for (ssize_t count = 0; (count = recv(socket_, part, sizeof part, 0)) > 0;)
      text.append(part, static_cast<std::size_t>(count));
    return text;
  }

 private:
  int socket_;
};

/// A server that runs in a thread of its own.
class Running {
 public:
  explicit Running(const serve::ServerLimits& limits)
      : server_(0, limits), thread_([this] {
          server_.run([](const Request&) { return std::nullopt; },
                      [this](const Request& request) {
                        if (request.target == "/throw") throw std::runtime_error("no");
                        Reply reply{200, "text/plain", request.body};
                        if (request.target == "/later")
                          reply.later = [this] {
                            return is_due ? std::optional(Reply{200, "", "late"}) : std::nullopt;
                          };
                        return reply;
                      });
        }) {}
  ~Running() {
    server_.stop();
    thread_.join();
  }
  unsigned short port() const { return server_.port(); }
  void wake() { server_.wake(); }

  std::atomic<bool> is_due = false;  ///< for the replies of "/later"

 private:
  HttpServer server_;
  std::thread thread_;
};

TEST(HttpServer, a_slow_client_is_cut_off_and_keeps_nobody_waiting) {
  serve::ServerLimits limits;
  limits.patience = std::chrono::milliseconds(300);
  limits.threads = 1;
  const Running server(limits);
  const Client slow(server.port());
  const auto begun = Clock::now();
  slow.send("POST / HTTP/1.1\r\nContent-Length: 100\r\n\r\nfew");
  const Client quick(server.port());
  quick.send("POST / HTTP/1.1\r\nContent-Length: 5\r\nConnection: close\r\n\r\nhello");
  const std::string answer = quick.rest();
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200")) << answer;
  EXPECT_TRUE(answer.ends_with("hello")) << answer;
  std::jthread drip([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      slow.send("x");
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
  EXPECT_EQ(slow.rest().find("200"), std::string::npos);
  EXPECT_GT(Clock::now() - begun, std::chrono::milliseconds(250));
  EXPECT_LT(Clock::now() - begun, std::chrono::seconds(20));
}

TEST(HttpServer, a_reply_that_comes_later_keeps_no_thread_and_comes_when_woken) {
  serve::ServerLimits limits;
  limits.threads = 1;
  limits.waiting = 2;
  limits.between_looks = std::chrono::hours(1);
  Running server(limits);
  const std::string request = "GET /later HTTP/1.1\r\nConnection: close\r\n\r\n";
  const Client first(server.port()), second(server.port()), third(server.port()), quick(server.port());
  for (const Client* client : {&first, &second, &third}) {
    client->send(request);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_TRUE(third.rest().starts_with("HTTP/1.1 503")) << "two may wait";
  quick.send("GET / HTTP/1.1\r\nConnection: close\r\n\r\n");
  EXPECT_TRUE(quick.rest().starts_with("HTTP/1.1 200"));
  server.is_due = true;
  server.wake();
  EXPECT_TRUE(first.rest().ends_with("late"));
  EXPECT_TRUE(second.rest().ends_with("late"));
}

TEST(HttpServer, connections_beyond_the_limit_are_refused_if_all_were_let_in) {
  serve::ServerLimits limits;
  limits.connections = 1;
  const Running server(limits);
  const Client first(server.port());
  first.send("POST / HTTP/1.1\r\nContent-Length: 5\r\n\r\n");
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const Client second(server.port());
  EXPECT_TRUE(second.rest().starts_with("HTTP/1.1 503"));
}

TEST(HttpServer, silent_connections_make_room_for_new_ones) {
  serve::ServerLimits limits;
  limits.connections = 2;
  const Running server(limits);
  const Client oldest(server.port());
  oldest.send("GET / HT");
  const Client silent(server.port());
  for (int i = 0; i < 5; ++i) {
    const Client quick(server.port());
    quick.send("GET / HTTP/1.1\r\nConnection: close\r\n\r\n");
    EXPECT_TRUE(quick.rest().starts_with("HTTP/1.1 200"));
  }
  EXPECT_EQ(oldest.rest(), "");
}

TEST(HttpServer, a_silent_connection_is_closed_early) {
  serve::ServerLimits limits;
  limits.first_patience = std::chrono::milliseconds(200);
  const Running server(limits);
  const auto begun = Clock::now();
  const Client silent(server.port());
  EXPECT_EQ(silent.rest(), "");
  EXPECT_LT(Clock::now() - begun, std::chrono::seconds(10));
}

TEST(HttpServer, a_second_host_is_refused) {
  const Running server(serve::ServerLimits{});
  const Client client(server.port());
  client.send("GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\nConnection: close\r\n\r\n");
  EXPECT_TRUE(client.rest().starts_with("HTTP/1.1 400"));
}

TEST(HttpServer, a_body_beyond_the_limit_is_refused_and_a_fault_is_told) {
  serve::ServerLimits limits;
  limits.body = 10;
  const Running server(limits);
  const Client large(server.port());
  large.send("POST / HTTP/1.1\r\nContent-Length: 11\r\n\r\n");
  EXPECT_TRUE(large.rest().starts_with("HTTP/1.1 413"));
  const Client fault(server.port());
  fault.send("GET /throw HTTP/1.1\r\nConnection: close\r\n\r\n");
  EXPECT_TRUE(fault.rest().starts_with("HTTP/1.1 500"));
}

}  // namespace
}  // namespace keyblock::http_server_test
