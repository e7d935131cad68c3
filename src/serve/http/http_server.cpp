// Carries requests and replies by Boost.Beast; the only file that includes it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/http/http_server.hpp"

#include <utility>
// Boost 1.74 uses std::exchange without this header.
#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/bind_executor.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <csignal>
#include <exception>
#include <functional>
#include <limits>
#include <list>
#include <optional>
#include <string>
#include <vector>

namespace keyblock::serve {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using Tcp = asio::ip::tcp;

constexpr std::uint32_t kMostHeader = 16384;

class Session;

/// Returns what `work` returns; a refusal if it throws.
template <class Work>
std::optional<Reply> caught(const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    return refusal(500, error.what());
  }
}

/// Requests whose reply comes later. All calls come from the thread of the context; replies are made in the pool.
class LateReplies {
 public:
  LateReplies(asio::io_context& context, asio::thread_pool& pool, const ServerLimits& limits)
      : context_(context), pool_(pool), limits_(limits), next_look_(context) {}

  /// Calls `give` with the reply that comes. Returns false if too many wait.
  bool add(std::function<std::optional<Reply>()> later, std::function<void(Reply)> give) {
    if (count_ >= limits_.waiting) return false;
    ++count_;
    waiting_.push_back({std::move(later), std::move(give)});
    look();
    return true;
  }

  void look() {
    looks_again_ = true;
    if (std::exchange(is_looking_, true)) return;
    looks_again_ = false;
    asio::post(pool_, [this, waiting = std::exchange(waiting_, {})]() mutable {
      for (Waiting& own : waiting) own.reply = caught(own.later);
      asio::post(context_, [this, waiting = std::move(waiting)]() mutable { on_looked(std::move(waiting)); });
    });
  }

 private:
  struct Waiting {
    std::function<std::optional<Reply>()> later;
    std::function<void(Reply)> give;
    std::optional<Reply> reply = {};
  };

  void on_looked(std::vector<Waiting> waiting) {
    is_looking_ = false;
    for (Waiting& own : waiting) {
      if (!own.reply) {
        waiting_.push_back(std::move(own));
        continue;
      }
      --count_;
      own.give(std::move(*own.reply));
    }
    if (looks_again_) return look();
    if (waiting_.empty()) return;
    next_look_.expires_after(limits_.between_looks);
    next_look_.async_wait([this](beast::error_code error) {
      if (!error) look();
    });
  }

  asio::io_context& context_;
  asio::thread_pool& pool_;
  const ServerLimits& limits_;
  asio::steady_timer next_look_;
  std::vector<Waiting> waiting_;
  std::size_t count_ = 0;  ///< those that are looked at included
  bool is_looking_ = false;
  bool looks_again_ = false;  ///< something has happened since the look began
};

/// What all connections share.
struct Shared {
  explicit Shared(const ServerLimits& of) : limits(of), pool(of.threads) {}

  HttpServer::Guarding guard;
  HttpServer::Handler handler;
  ServerLimits limits;
  asio::thread_pool pool;  ///< in which requests are answered
  std::atomic<std::size_t> connections = 0;
  std::list<std::weak_ptr<Session>> strangers;  ///< connections by age that were not let in yet
  asio::io_context context{1};                  ///< its waiting calls own sessions, which refer to the members above
  LateReplies late{context, pool, limits};
};

/// Fields that decide about a request, of which a second one could hide the first.
constexpr std::array<http::field, 4> kSingleFields{http::field::host, http::field::origin, http::field::cookie,
                                                   http::field::content_type};

bool has_twice(const http::request<http::string_body>& request) {
  return std::ranges::any_of(kSingleFields, [&](http::field field) { return request.count(field) > 1; });
}

Request request_from(const http::request<http::string_body>& from) {
  const auto field = [&](http::field name) { return std::string(from[name]); };
  return {std::string(from.method_string()),
          std::string(from.target()),
          field(http::field::host),
          field(http::field::origin),
          field(http::field::cookie),
          field(http::field::content_type),
          from.body()};
}

http::response<http::string_body> response_from(Reply reply, bool keeps_alive) {
  http::response<http::string_body> response(static_cast<http::status>(reply.status), 11);
  response.set(http::field::content_type, reply.type);
  response.set(http::field::cache_control, "no-store");
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  for (const auto& [name, value] : reply.headers) response.set(name, value);
  response.keep_alive(keeps_alive);
  response.body() = std::move(reply.body);
  response.prepare_payload();
  return response;
}

/// One connection, which lives as long as one of its calls waits.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(Tcp::socket socket, Shared& shared) : stream_(std::move(socket)), shared_(shared) { ++shared_.connections; }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() { --shared_.connections; }

  void start() {
    if (shared_.connections > shared_.limits.connections && !make_room())
      return write(refusal(503, "too many connections"), false);
    forget_known();
    shared_.strangers.push_back(weak_from_this());
    read();
  }

 private:
  /// Drops connections that ended or were let in.
  void forget_known() {
    std::erase_if(shared_.strangers, [](const std::weak_ptr<Session>& stranger) {
      const std::shared_ptr<Session> session = stranger.lock();
      return !session || session->is_let_in_;
    });
  }

  /// Ends the oldest connection that was not let in yet. Returns false if all were let in.
  bool make_room() {
    auto& strangers = shared_.strangers;
    forget_known();
    if (strangers.empty()) return false;
    if (const std::shared_ptr<Session> oldest = strangers.front().lock()) oldest->stream_.close();
    strangers.pop_front();
    return true;
  }

  void read() {
    parser_.emplace();
    parser_->header_limit(kMostHeader);
    parser_->body_limit(std::numeric_limits<std::uint64_t>::max());  // a stranger learns nothing about the limit
    stream_.expires_after(is_let_in_ ? shared_.limits.patience : shared_.limits.first_patience);
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = shared_from_this()](beast::error_code error, std::size_t) {
                              if (!self->has_failed(error)) self->on_header();
                            });
  }

  bool has_failed(beast::error_code error) {
    if (!error) return false;
    if (error == http::error::body_limit)
      write(refusal(413, "the body is too long"), false);
    else if (error == http::error::header_limit)
      write(refusal(431, "the header is too long"), false);
    else if (error == http::error::end_of_stream || error == beast::error::timeout ||
             error.category() == asio::error::get_system_category())
      close();
    else
      write(refusal(400, "the request is not HTTP"), false);
    return true;
  }

  void on_header() {
    if (has_twice(parser_->get())) return write(refusal(400, "a field of the header stands twice"), false);
    if (std::optional<Reply> refused = shared_.guard(request_from(parser_->get())))
      return write(std::move(*refused), parser_->is_done() && parser_->get().keep_alive());
    is_let_in_ = true;
    if (parser_->content_length().value_or(0) > shared_.limits.body)
      return write(refusal(413, "the body is too long"), false);
    parser_->body_limit(shared_.limits.body);
    stream_.expires_after(shared_.limits.patience);
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (!self->has_failed(error)) self->on_request();
    });
  }

  void on_request() {
    stream_.expires_never();
    asio::post(shared_.pool, [self = shared_from_this()] {
      const http::request<http::string_body> request = self->parser_->release();
      std::optional<Reply> reply = caught([&] { return self->shared_.handler(request_from(request)); });
      asio::post(self->stream_.get_executor(),
                 [self, reply = std::move(*reply), keeps = request.keep_alive()]() mutable {
                   if (reply.later) return self->wait(std::move(reply.later), keeps);
                   self->write(std::move(reply), keeps);
                 });
    });
  }

  void wait(std::function<std::optional<Reply>()> later, bool keeps_alive) {
    const bool waits = shared_.late.add(std::move(later), [self = shared_from_this(), keeps_alive](Reply reply) {
      self->write(std::move(reply), keeps_alive);
    });
    if (!waits) write(refusal(503, "too many requests wait"), keeps_alive);
  }

  void write(Reply reply, bool keeps_alive) {
    response_.emplace(response_from(std::move(reply), keeps_alive));
    stream_.expires_after(shared_.limits.patience);
    http::async_write(stream_, *response_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error || !self->response_->keep_alive()) return self->close();
      self->read();
    });
  }

  void close() {
    beast::error_code ignored;
    stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
  }

  bool is_let_in_ = false;  ///< a request has passed the guard
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_{kMostHeader + 65536};
  std::optional<http::request_parser<http::string_body>> parser_;
  std::optional<http::response<http::string_body>> response_;
  Shared& shared_;
};

}  // namespace

struct HttpServer::Parts {
  Parts(unsigned short port, const ServerLimits& limits)
      : shared(limits), acceptor(shared.context), signals(shared.context, SIGINT, SIGTERM, SIGHUP) {
    const Tcp::endpoint here(asio::ip::address_v4::loopback(), port);
    acceptor.open(here.protocol());
    acceptor.set_option(asio::socket_base::reuse_address(true));
    acceptor.bind(here);
    acceptor.listen(asio::socket_base::max_listen_connections);
  }

  void accept() {
    acceptor.async_accept([this](beast::error_code error, Tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (!error) std::make_shared<Session>(std::move(socket), shared)->start();
      accept();
    });
  }

  Shared shared;
  Tcp::acceptor acceptor;
  asio::signal_set signals;
};

HttpServer::HttpServer(unsigned short port, const ServerLimits& limits) {
  try {
    parts_ = std::make_unique<Parts>(port, limits);
  } catch (const boost::system::system_error& error) {
    throw std::system_error(error.code().value(), std::system_category(), "port " + std::to_string(port));
  }
}

HttpServer::~HttpServer() = default;

unsigned short HttpServer::port() const {
  return parts_->acceptor.local_endpoint().port();
}

void HttpServer::run(Guarding guard, Handler handler, const std::function<void()>& on_stop) {
  parts_->shared.guard = std::move(guard);
  parts_->shared.handler = std::move(handler);
  parts_->signals.async_wait([this](beast::error_code error, int) {
    if (!error) stop();
  });
  parts_->accept();
  parts_->shared.context.run();
  if (on_stop) on_stop();
  parts_->shared.pool.join();
}

void HttpServer::wake() {
  asio::post(parts_->shared.context, [this] { parts_->shared.late.look(); });
}

void HttpServer::stop() {
  parts_->shared.context.stop();
}

}  // namespace keyblock::serve
