// Reads the log of a process for its last error.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/logged_child.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstring>
#include <sstream>
#include <string_view>
#include <system_error>

#include "app/exit_code.hpp"
#include "base/error.hpp"
#include "formats/registry.hpp"

namespace keyblock {

namespace fs = std::filesystem;

bool has_been_stopped(const ChildEnd& end) {
  if (end.ran_out_of_time) return false;
  const bool by_request = end.signal == SIGTERM || end.signal == SIGINT || end.exit_code == int(ExitCode::stopped);
  return by_request || (end.was_stopped && end.signal != 0);
}

std::string error_in(const fs::path& log) {
  std::istringstream lines(formats::load(log.string()).text);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (line.find("error:") != std::string::npos) last = line;
  return last;
}

ChildEnd run_logged(const std::vector<std::string>& arguments, const ChildLimits& limits, const fs::path& folder,
                    const std::string& name, const Context* stop) {
  constexpr std::string_view kLevel = "error: ";
  const fs::path log = folder / (name + ".log");
  const ChildEnd end = run_child(arguments, limits, folder / (name + ".out"), log, stop);
  if (end.exit_code != kCannotWrite) return end;
  const std::string error = error_in(log);  // empty: the disk had no room for it either
  const std::size_t at = error.find(kLevel);
  throw OutputError(at == std::string::npos ? fmt::format("cannot write into {}", folder.string())
                                            : error.substr(at + kLevel.size()));
}

// Below some limit the system, the loader or a library ends the program before it begins, each in its own way.
bool can_start(const ChildLimits& limits) {
  return run_child({"--version"}, limits, "/dev/null", "/dev/null").exit_code == 0;
}

bool is_starved(const ChildEnd& end, const ChildLimits& limits) {
  if (limits.memory_mebibytes <= 0 || end.ran_out_of_time || end.exit_code == int(ExitCode::ok)) return false;
  return end.exit_code == int(ExitCode::limit) || !can_start(limits);
}

std::string signal_of(const ChildEnd& end, const ChildLimits& limits) {
  const char* abbreviation = sigabbrev_np(end.signal);
  const std::string name =
      abbreviation != nullptr ? fmt::format("SIG{}", abbreviation) : fmt::format("signal {}", end.signal);
  if (limits.memory_mebibytes <= 0) return name;
  return fmt::format("{} under the limit of {} MiB of memory, which may be too small", name, limits.memory_mebibytes);
}

std::string why_it_ended(const ChildEnd& end, const ChildLimits& limits, const fs::path& log) {
  if (end.ran_out_of_time) return fmt::format("stopped at the limit of {} s of processor time", limits.cpu_seconds);
  if (is_starved(end, limits))
    return fmt::format("the limit of {} MiB of memory is too small for it", limits.memory_mebibytes);
  if (end.signal != 0) return fmt::format("ended by {}", signal_of(end, limits));
  const std::string error = error_in(log);
  return fmt::format("exit code {}{}{}", end.exit_code, error.empty() ? "" : ": ", error);
}

fs::path empty_folder(const fs::path& folder) {
  std::error_code error;
  fs::remove_all(folder, error);
  if (!error) fs::create_directories(folder, error);
  if (error) throw OutputError(fmt::format("cannot make {}: {}", folder.string(), error.message()));
  return folder;
}

}  // namespace keyblock
