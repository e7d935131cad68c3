// Starts programs by fork and exec, and waits with their resource usage.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/program.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <functional>

#include "tests/support/text_files.hpp"

namespace keyblock::support {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void become(const std::vector<std::string>& words, const std::string& output,
                         const std::string& messages) {
  const int out = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err = open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(arguments.front(), arguments.data());
  _exit(127);
}

constexpr useconds_t kMicrosecondsBetweenLooks = 10000;

// Leaves the process to be waited for.
bool is_running(pid_t child) {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0;
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

}  // namespace

std::string fresh_folder(const std::string& name) {
  const fs::path folder = fs::temp_directory_path() / ("keyblock_test_" + std::to_string(getpid())) / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder.string();
}

namespace {

// `meanwhile` is called once, with the process that was started.
ProgramRun run_words(const std::vector<std::string>& words, const std::function<void(pid_t)>& meanwhile) {
  const fs::path folder = fs::temp_directory_path() / ("keyblock_test_" + std::to_string(getpid()));
  fs::create_directories(folder);
  const std::string output = (folder / "stdout").string();
  const std::string messages = (folder / "stderr").string();
  const pid_t child = fork();
  if (child == 0) become(words, output, messages);
  meanwhile(child);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(output), read_text(messages),
          seconds(usage.ru_utime) + seconds(usage.ru_stime), static_cast<double>(usage.ru_maxrss) / 1024};
}

ProgramRun run_program(const std::vector<std::string>& arguments, const std::function<void(pid_t)>& meanwhile) {
  std::vector<std::string> words{KEYBLOCK_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_words(words, meanwhile);
}

}  // namespace

ProgramRun run_keyblock(const std::vector<std::string>& arguments) {
  return run_program(arguments, [](pid_t) {});
}

ProgramRun interrupt_keyblock(const std::vector<std::string>& arguments, const std::string& file, int signal) {
  return run_program(arguments, [&](pid_t child) {
    while (!fs::exists(file) && is_running(child)) usleep(kMicrosecondsBetweenLooks);
    kill(child, signal);
  });
}

ProgramRun run_keyblock(const std::vector<std::string>& arguments, const std::string& file,
                        const std::function<void()>& meanwhile) {
  return run_program(arguments, [&](pid_t child) {
    while (!fs::exists(file) && is_running(child)) usleep(kMicrosecondsBetweenLooks);
    meanwhile();
  });
}

ProgramRun run_script(const std::string& script) {
  return run_words({"/bin/sh", "-c", "K='" KEYBLOCK_PROGRAM "'\n" + script}, [](pid_t) {});
}

ProgramRun kill_keyblock(const std::vector<std::string>& arguments, double seconds) {
  return run_program(arguments, [&](pid_t child) {
    usleep(static_cast<useconds_t>(1e6 * seconds));
    if (is_running(child)) kill(child, SIGKILL);
  });
}

ProgramRun kill_keyblock(const std::vector<std::string>& arguments, const std::string& file, int lines) {
  return run_program(arguments, [&](pid_t child) {
    while (is_running(child) && std::ranges::count(read_text(file), '\n') < lines) usleep(kMicrosecondsBetweenLooks);
    kill(child, SIGKILL);
  });
}

}  // namespace keyblock::support
