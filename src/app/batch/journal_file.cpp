// Writes lines with one system call each.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/journal_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "app/progress.hpp"
#include "base/error.hpp"

namespace keyblock {
namespace {

constexpr auto kBetweenReports = std::chrono::seconds(5);

}  // namespace

JournalFile::JournalFile(const std::filesystem::path& file) : name_(file.string()) {
  descriptor_ = open(name_.c_str(), O_WRONLY | O_APPEND);
  if (descriptor_ < 0) throw OutputError(fmt::format("cannot write {}", name_));
}

JournalFile::~JournalFile() {
  close(descriptor_);
}

void JournalFile::add(const std::string& line) const {
  errno = 0;
  if (write(descriptor_, line.data(), line.size()) == static_cast<ssize_t>(line.size())) return;
  const int why = errno != 0 ? errno : ENOSPC;  // a part was written
  throw OutputError(fmt::format("cannot write {}: {}", name_, std::generic_category().message(why)));
}

void JobReports::add_one() {
  ++done_;
  if (Clock::now() - shown_ < kBetweenReports) return;
  shown_ = Clock::now();
  const double taken = std::chrono::duration<double>(Clock::now() - begun_).count();
  const double left = taken * static_cast<double>(jobs_ - done_) / static_cast<double>(done_);
  spdlog::info("{} of {} jobs done, about {} left", done_, jobs_, time_in_words(left));
}

}  // namespace keyblock
