// Reads the log of a process for its last error.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/logged_child.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string_view>
#include <system_error>

#include "app/exit_code.hpp"
#include "base/error.hpp"
#include "formats/registry.hpp"

namespace keyblock {

namespace fs = std::filesystem;

namespace {

constexpr int kNoRoomForLibraries = 127;  // exit code of the loader
constexpr std::uintmax_t kMebibyte = 1048576;

}  // namespace

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

// The system cannot load a program larger than the limit, and ends it by a signal.
bool is_below_the_program(const ChildLimits& limits) {
  std::error_code error;
  const auto size = fs::file_size("/proc/self/exe", error);
  return !error && static_cast<std::uintmax_t>(limits.memory_mebibytes) * kMebibyte < size;
}

bool is_starved(const ChildEnd& end, const ChildLimits& limits) {
  const bool is_at_limit = end.exit_code == int(ExitCode::limit) && !end.ran_out_of_time;
  return limits.memory_mebibytes > 0 &&
         (end.exit_code == kNoRoomForLibraries || is_at_limit || (end.signal != 0 && is_below_the_program(limits)));
}

std::string signal_name(int signal) {
  const char* abbreviation = sigabbrev_np(signal);
  return abbreviation != nullptr ? fmt::format("SIG{}", abbreviation) : fmt::format("signal {}", signal);
}

std::string why_it_ended(const ChildEnd& end, const ChildLimits& limits, const fs::path& log) {
  if (end.ran_out_of_time) return fmt::format("stopped at the limit of {} s of processor time", limits.cpu_seconds);
  if (is_starved(end, limits))
    return fmt::format("the limit of {} MiB of memory is too small for it", limits.memory_mebibytes);
  if (end.signal != 0) return fmt::format("ended by {}", signal_name(end.signal));
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
