// Starts a process by fork, limits, exec and wait. Between fork and exec only safe calls are made: other threads may
// hold any lock.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

#include "app/exit_code.hpp"
#include "base/error.hpp"

namespace keyblock {
namespace {

constexpr int kCannotStart = 126;  // 127 belongs to the loader, if a limit leaves no memory for libraries

struct Plan {
  std::vector<char*> arguments;
  std::string output;
  std::string messages;
  ChildLimits limits;
  pid_t parent;
  sigset_t mask;  ///< of signals, as before the fork
};

bool send_to(const std::string& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  return opened >= 0 && dup2(opened, descriptor) >= 0;
}

// A run that is stopped still writes its results so far: it gets this many seconds, or a tenth of its time if longer.
constexpr rlim_t kLeastGrace = 5;

rlim_t grace(rlim_t seconds) {
  return std::max(kLeastGrace, seconds / 10);
}

// The first limit requests the process to end; the second, above it, kills it.
bool limit(int resource, rlim_t first, rlim_t second) {
  const rlimit both{first, second};
  return setrlimit(static_cast<__rlimit_resource>(resource), &both) == 0;
}

[[noreturn]] void become(const Plan& plan) {
  bool is_ready = setpgid(0, 0) == 0 && prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && getppid() == plan.parent;
  // A stop that came before exec must end the process, and not call a handler that is forgotten then.
  for (const int signal : {SIGINT, SIGTERM, SIGXCPU}) std::signal(signal, SIG_DFL);
  is_ready = is_ready && pthread_sigmask(SIG_SETMASK, &plan.mask, nullptr) == 0;
  if (const auto seconds = static_cast<rlim_t>(plan.limits.cpu_seconds); seconds > 0)
    is_ready = is_ready && limit(RLIMIT_CPU, seconds, seconds + grace(seconds));
  if (const auto bytes = static_cast<rlim_t>(plan.limits.memory_mebibytes) << 20U; bytes > 0)
    is_ready = is_ready && limit(RLIMIT_AS, bytes, bytes);
  is_ready = is_ready && limit(RLIMIT_CORE, 0, 0);
  const int nothing = open("/dev/null", O_RDONLY);
  is_ready = is_ready && dup2(nothing, STDIN_FILENO) >= 0 && send_to(plan.output, STDOUT_FILENO) &&
             send_to(plan.messages, STDERR_FILENO);
  if (is_ready) execv("/proc/self/exe", plan.arguments.data());
  _exit(kCannotStart);
}

/// Waits for the end of the child, and forwards a stop once. Returns true if a stop was forwarded.
bool wait_for(pid_t child, const Context& stop) {
  constexpr int kLook = 100;  // milliseconds
  const auto descriptor = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
  bool was_stopped = false;
  pollfd ended{descriptor, POLLIN, 0};
  while (descriptor >= 0 && poll(&ended, 1, was_stopped ? -1 : kLook) <= 0) {
    if (was_stopped || !stop.is_stopped()) continue;
    kill(child, SIGTERM);
    was_stopped = true;
  }
  if (descriptor >= 0) close(descriptor);
  return was_stopped;
}

// The limit of memory has the same exit code. The accounted time may be a sixth shorter than the time that ends a
// process.
bool has_used_its_time(const rusage& used, double limit_seconds) {
  constexpr double kMicro = 1e-6, kSurely = 0.5;
  const double seconds = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                         kMicro * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
  return seconds >= kSurely * limit_seconds;
}

}  // namespace

ChildEnd run_child(const std::vector<std::string>& arguments, const ChildLimits& limits,
                   const std::filesystem::path& output, const std::filesystem::path& messages, const Context* stop) {
  std::string name = kJobName;
  Plan plan{{name.data()}, output.string(), messages.string(), limits, getpid(), {}};
  for (const std::string& argument : arguments) plan.arguments.push_back(const_cast<char*>(argument.c_str()));
  plan.arguments.push_back(nullptr);
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &plan.mask);
  const pid_t child = fork();
  if (child == 0) become(plan);
  pthread_sigmask(SIG_SETMASK, &plan.mask, nullptr);
  const bool was_stopped = child > 0 && stop != nullptr && wait_for(child, *stop);
  int status = 0;
  rusage used{};
  while (child > 0 && wait4(child, &status, 0, &used) < 0 && errno == EINTR) continue;
  const bool was_killed = WIFSIGNALED(status);
  if (child < 0 || (!was_killed && WEXITSTATUS(status) == kCannotStart))
    throw OutputError(fmt::format("cannot start this program again, or write {}", messages.string()));
  const int signal = was_killed ? WTERMSIG(status) : 0;
  const bool says_so = !was_killed && WEXITSTATUS(status) == static_cast<int>(ExitCode::limit) &&
                       has_used_its_time(used, limits.cpu_seconds);
  const bool by_limit = limits.cpu_seconds > 0 && (signal == SIGXCPU || signal == SIGKILL || says_so);
  return {was_killed ? 128 + signal : WEXITSTATUS(status), by_limit, signal, was_stopped};
}

}  // namespace keyblock
