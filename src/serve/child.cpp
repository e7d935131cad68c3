// Forks and executes; between both only calls that are safe beside other threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <thread>

namespace keyblock::serve {
namespace {

namespace fs = std::filesystem;

constexpr int kCannotStart = 126;
constexpr std::string_view kDrafts = "keyblock-serve-";
constexpr std::chrono::seconds kOldDrafts{60};
constexpr std::chrono::seconds kPatience{120};  // for a check, a drawing, a page
constexpr std::chrono::milliseconds kPause{10};
constexpr std::size_t kMostOutput = 64U << 20U;  // bytes

struct Words {
  std::vector<char*> arguments;
  std::string folder, output, messages;
  pid_t parent;
};

bool send_to(const std::string& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  return opened >= 0 && dup2(opened, descriptor) >= 0;
}

[[noreturn]] void become(const Words& words, const sigset_t& signals) {
  bool is_ready = setpgid(0, 0) == 0 && prctl(PR_SET_PDEATHSIG, SIGTERM) == 0 && getppid() == words.parent;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
  is_ready = is_ready && sigprocmask(SIG_SETMASK, &signals, nullptr) == 0;
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  is_ready = is_ready && dup2(nothing, STDIN_FILENO) >= 0 && send_to(words.output, STDOUT_FILENO) &&
             send_to(words.messages, STDERR_FILENO) && chdir(words.folder.c_str()) == 0;
  for (int descriptor = STDERR_FILENO + 1; descriptor < 1024; ++descriptor) close(descriptor);
  if (is_ready) execv("/proc/self/exe", words.arguments.data());
  _exit(kCannotStart);
}

/// Removes the user's folders of drafts that no server holds.
void remove_left_behind() {
  std::error_code error;
  std::vector<fs::path> left;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::temp_directory_path(), error)) {
    struct stat status {};
    if (!entry.path().filename().string().starts_with(kDrafts) || lstat(entry.path().c_str(), &status) != 0) continue;
    // A younger folder may belong to a server that is about to lock it.
    const bool is_old = std::time(nullptr) - status.st_mtime > kOldDrafts.count();
    if (S_ISDIR(status.st_mode) && status.st_uid == getuid() && is_old && !is_locked(entry.path()))
      left.push_back(entry.path());
  }
  for (const fs::path& folder : left) fs::remove_all(folder, error);
}

std::string beginning_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  char part[1U << 16U];
  while (text.size() < kMostOutput && (stream.read(part, sizeof part), stream.gcount() > 0))
    text.append(part, static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments, const fs::path& folder, const fs::path& output,
             const fs::path& messages) {
  std::string name = "keyblock";
  Words words{{name.data()}, folder.string(), output.string(), messages.string(), getpid()};
  for (const std::string& argument : arguments) words.arguments.push_back(const_cast<char*>(argument.c_str()));
  words.arguments.push_back(nullptr);
  // A signal before the child has handlers of its own would run the server's, and tell the server to stop.
  sigset_t all{}, before{};
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  process_ = fork();
  if (process_ == 0) become(words, before);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (process_ < 0) throw std::runtime_error("cannot start this program again");
}

Child::~Child() {
  if (ended()) return;
  kill(process_, SIGKILL);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
}

std::optional<int> Child::ended() {
  if (code_) return code_;
  int status = 0;
  const pid_t found = waitpid(process_, &status, WNOHANG);
  if (found == process_) code_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return code_;
}

void Child::send(int signal) const {
  if (!code_) kill(process_, signal);
}

Drafts::Drafts() {
  remove_left_behind();
  std::string name = (fs::temp_directory_path() / (std::string(kDrafts) + "XXXXXX")).string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for temporary files");
  folder_ = name;
  lock_ = FolderLock(folder_);
}

Drafts::~Drafts() {
  std::error_code error;
  fs::remove_all(folder_, error);
}

fs::path Drafts::file(const std::string& ending) const {
  static std::atomic<unsigned> count = 0;
  return folder_ / fmt::format("{}{}", ++count, ending);
}

Answer Program::operator()(const std::vector<std::string>& arguments) const {
  const fs::path output = drafts_.file(".out"), messages = drafts_.file(".err");
  Answer answer;
  {
    Child child(arguments, folder_, output, messages);
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!child.ended() && !is_stopping_ && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(kPause);
    answer.ran_out_of_time = !child.ended();
    answer.exit_code = child.ended().value_or(128 + SIGKILL);
    answer.process = child.process();
  }
  answer.output = beginning_of(output);
  answer.messages = beginning_of(messages);
  std::error_code error;
  fs::remove(output, error);
  fs::remove(messages, error);
  return answer;
}

}  // namespace keyblock::serve
