// Finds the text of an input by its checksum: on the disk as it was, or among the copies.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/study/input_copies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "base/bytes/file_bytes.hpp"
#include "base/bytes/sha256.hpp"
#include "base/bytes/sound_json.hpp"
#include "base/printable.hpp"
#include "serve/run_differences.hpp"

namespace keyblock::serve {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMostCopied = 16U << 20U;  // bytes of a file
constexpr std::size_t kMostCopies = 1000;
constexpr std::size_t kMostLines = 100;  // differing lines of a file
constexpr std::size_t kDigestLength = 64;

std::string member_text(const Json& of, const char* key) {
  const auto found = of.is_object() ? of.find(key) : of.end();
  return found != of.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(valid_utf8(line));
  return lines;
}

void add_lines(Json& found, const std::string& name, const std::string& first, const std::string& second) {
  const std::vector<std::string> a = lines_of(first), b = lines_of(second);
  if (a.size() != b.size()) {
    found.push_back(
        {{"path", name}, {"first", fmt::format("{} lines", a.size())}, {"second", fmt::format("{} lines", b.size())}});
    return;
  }
  for (std::size_t i = 0; i < a.size() && found.size() < kMostLines; ++i)
    if (a[i] != b[i])
      found.push_back({{"path", fmt::format("{} line {}", name, i + 1)}, {"first", a[i]}, {"second", b[i]}});
}

// Adds the values of two case files that differ, or their lines.
void add_differences(Json& found, const std::string& name, const std::string& first, const std::string& second) {
  const auto parsed = [](const std::string& text) { return sound_json(text, true); };
  const Json a = parsed(first), b = parsed(second);
  if (!a.is_object() || !b.is_object()) return add_lines(found, name, first, second);
  for (Json& difference : value_differences(a, b)) found.push_back(std::move(difference));
}

}  // namespace

fs::path InputCopies::copy_of(const std::string& digest) const {
  return drafts_.folder() / "inputs" / digest;
}

void InputCopies::keep(const fs::path& path) const {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(path, error))
      if (entry.is_regular_file(error) && !entry.is_symlink(error)) keep(entry.path());
    return;
  }
  if (!fs::is_regular_file(path, error) || fs::file_size(path, error) > kMostCopied) return;
  fs::create_directories(drafts_.folder() / "inputs", error);
  try {
    const fs::path copy = copy_of(sha256(file_bytes(path.string())));
    fs::copy_file(path, copy, fs::copy_options::skip_existing, error);
    fs::last_write_time(copy, fs::file_time_type::clock::now(), error);  // a file used again is the newest
    drop_oldest();
  } catch (const std::exception&) {
    return;  // the run itself reports a file that cannot be read
  }
}

void InputCopies::drop_oldest() const {
  std::vector<std::pair<fs::file_time_type, fs::path>> copies;
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(drafts_.folder() / "inputs")) {
    copies.emplace_back(entry.last_write_time(), entry.path());
    bytes += entry.file_size();
  }
  std::ranges::sort(copies);
  for (std::size_t i = 0; i + 1 < copies.size() && (bytes > most_in_all_ || copies.size() - i > kMostCopies); ++i) {
    bytes -= fs::file_size(copies[i].second);
    fs::remove(copies[i].second);
  }
}

std::optional<std::string> InputCopies::text_of(const Json& input) const {
  const std::string digest = member_text(input, "sha256"), name = member_text(input, "file");
  std::error_code error;
  const bool is_digest =
      digest.size() == kDigestLength && std::ranges::all_of(digest, [](unsigned char c) { return std::isxdigit(c); });
  try {
    if (is_digest && fs::is_regular_file(copy_of(digest), error)) return file_bytes(copy_of(digest).string());
    const fs::path file = folder_.whole(name);
    if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > kMostCopied) return std::nullopt;
    std::string text = file_bytes(file.string());
    if (sha256(text) == digest) return text;
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return std::nullopt;
}

Json InputCopies::differences(const Json& first, const Json& second) const {
  Json found = Json::array();
  const Json a = first.value("inputs", Json::array()), b = second.value("inputs", Json::array());
  const std::size_t count = std::max(a.size(), b.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Json none, &x = i < a.size() ? a[i] : none, &y = i < b.size() ? b[i] : none;
    if (member_text(x, "sha256") == member_text(y, "sha256")) continue;
    const auto text = text_of(x), other = text_of(y);
    if (text && other)
      add_differences(found, member_text(x, "file"), *text, *other);
    else
      found.push_back({{"path", fmt::format("file {}", i + 1)},
                       {"first", member_text(x, "file") + (text ? "" : " (moved or changed since)")},
                       {"second", member_text(y, "file") + (other ? "" : " (moved or changed since)")}});
  }
  return found;
}

}  // namespace keyblock::serve
