// Opens and closes the file for each lot of rows, so that readers see whole lines.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/folder/growing_table.hpp"

#include <fmt/format.h>

#include <system_error>

#include "base/error.hpp"
#include "formats/registry.hpp"
#include "job/files.hpp"

namespace keyblock {

namespace {

constexpr std::size_t kLot = 1 << 16;                   // bytes
constexpr std::chrono::milliseconds kLongestWait{250};  // before readers see new rows

}  // namespace

void GrowingTable::count(const std::string& bytes) {
  size_ += bytes.size();
  digest_.add(bytes);
}

void GrowingTable::append(const std::string& rows) {
  if (rows.empty()) return;
  if (!has_begun()) {
    write_file(file_, header_ + rows);
    written_ = std::chrono::steady_clock::now();
    return count(header_ + rows);
  }
  waiting_ += rows;
  count(rows);
  if (waiting_.size() > kLot || std::chrono::steady_clock::now() - written_ > kLongestWait) write_waiting();
}

void GrowingTable::write_waiting() {
  if (waiting_.empty()) return;
  append_to_file(file_, waiting_);
  waiting_.clear();
  written_ = std::chrono::steady_clock::now();
}

void GrowingTable::describe(Archive& archive) {
  if (!archive.is_restoring()) write_waiting();
  std::string digest = digest_.text();
  archive.value("size", size_);
  archive.value("sha256", digest);
  if (!archive.is_restoring() || size_ == 0) return;
  const auto refuse = [&](const std::string& found) {
    throw InputError({file_.string()},
                     fmt::format("expected the first {} bytes as the run wrote them, found {}; put the "
                                 "file back, or begin the run again",
                                 size_, found));
  };
  if (!std::filesystem::is_regular_file(file_)) refuse("no such file");
  const std::string text = formats::load(file_.string()).text;
  if (text.size() < size_) refuse(fmt::format("a file of {} bytes", text.size()));
  digest_ = Sha256();
  digest_.add(std::string_view(text).substr(0, size_));
  if (digest_.text() != digest) refuse("other bytes");
}

void GrowingTable::drop_what_followed() {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file_)) return;
  if (size_ == 0)
    std::filesystem::remove(file_, error);
  else
    std::filesystem::resize_file(file_, size_, error);
  if (error) throw OutputError(fmt::format("cannot cut back {}: {}", file_.string(), error.message()));
}

void GrowingTable::flush() {
  write_waiting();
  if (has_begun()) flush_to_disk(file_);
}

}  // namespace keyblock
