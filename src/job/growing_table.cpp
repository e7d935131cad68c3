// Appends through a stream that is closed each time, so that whoever reads meets all rows so far.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/growing_table.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "formats/registry.hpp"
#include "job/files.hpp"

namespace keyblock {

void GrowingTable::append(const std::string& rows) {
  if (rows.empty()) return;
  if (!std::exchange(has_begun_, true)) return write_file(file_, header_ + rows);
  std::ofstream stream(file_, std::ios::app | std::ios::binary);
  stream << rows;
  stream.close();
  if (!stream)
    throw OutputError(fmt::format("cannot write to {}: {}", file_.string(), std::generic_category().message(errno)));
}

void GrowingTable::keep_steps(const std::set<int>& steps) {
  keep([&](int step) { return steps.contains(step); });
}

void GrowingTable::keep_until(int last_step) {
  keep([&](int step) { return step <= last_step; });
}

void GrowingTable::keep(const std::function<bool(int)>& is_kept) {
  if (!std::filesystem::is_regular_file(file_)) return;
  const std::string text = formats::load(file_.string()).text;
  std::string kept;
  std::string_view rest = text;
  if (rest.starts_with(header_)) rest.remove_prefix(header_.size());
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) break;  // half a line
    int step = -1;
    std::from_chars(rest.data(), rest.data() + end, step);
    if (is_kept(step)) kept += rest.substr(0, end + 1);
    rest.remove_prefix(end + 1);
  }
  has_begun_ = !kept.empty();
  if (has_begun_)
    write_file(file_, header_ + kept);
  else
    std::filesystem::remove(file_);
}

void GrowingTable::flush() const {
  if (has_begun_) flush_to_disk(file_);
}

}  // namespace keyblock
