// `keyblock serve`: a window in the browser, for the files and results of one folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "app/command.hpp"
#include "base/bytes/file_bytes.hpp"
#include "base/error.hpp"
#include "serve/http/guard.hpp"
#include "serve/http/http_server.hpp"
#include "serve/service.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;

struct ServeOptions {
  std::string folder = ".";
  int port = 0;
  int at_once = 1;
};

ExitCode serve_folder(const ServeOptions& options) {
  std::signal(SIGPIPE, SIG_IGN);             // a browser that is gone
  setenv("KEYBLOCK_LOG_SECONDS", "0.5", 0);  // of the runs that it starts
  const serve::ServedFolder folder(options.folder);
  const serve::Drafts drafts;
  setenv(kReadsBelow, fmt::format("{}\n{}", folder.root().string(), fs::canonical(drafts.folder()).string()).c_str(),
         1);
  std::unique_ptr<serve::HttpServer> server;
  try {
    server = std::make_unique<serve::HttpServer>(static_cast<unsigned short>(options.port), serve::ServerLimits{});
  } catch (const std::system_error& error) {
    throw UsageError(fmt::format("--port {}: {}", options.port, error.code().message()));
  }
  serve::Jobs jobs(folder.root(), drafts, static_cast<std::size_t>(options.at_once));
  serve::Service service(folder, drafts, jobs, [&] { server->wake(); });
  const serve::Guard guard(serve::random_token(), server->port());
  fmt::print("{}\n", guard.address());
  std::fflush(stdout);
  spdlog::info("open this address in a browser on this machine; Ctrl-C ends it");
  server->run([&](const serve::Request& request) { return guard.answer(request); },
              [&](const serve::Request& request) { return service.answer(request); },
              [&] {
                service.stop_waiting();
                spdlog::info("stopping; runs write their results");
              });
  return ExitCode::ok;
}

}  // namespace

Action configure_serve(CLI::App& options) {
  const auto chosen = std::make_shared<ServeOptions>();
  options.add_option("DIR", chosen->folder, "folder of cases and results (default: the current folder)")
      ->check(CLI::ExistingDirectory);
  options.add_option("--port", chosen->port, "port on this machine (default: 0, a free one)")
      ->check(CLI::Range(0, 65535));
  options.add_option("--at-once", chosen->at_once, "runs at the same time; others wait (default: 1)")
      ->check(CLI::Range(1, 64));
  return [chosen] { return serve_folder(*chosen); };
}

}  // namespace keyblock
