// Resolves paths and lists cases and results.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/served_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <string_view>
#include <vector>

#include "api/case_file.hpp"
#include "base/bytes/sound_json.hpp"
#include "base/printable.hpp"
#include "study/sweep/sweep_table.hpp"

namespace keyblock::serve {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 21> kInputs{".json", ".yaml", ".yml",   ".dxf",   ".geo", ".ana", ".blk",
                                                   ".cv",   ".mf",   ".ml",    ".mc",    ".df",  ".dl",  ".dc",
                                                   ".dcg",  ".xml",  ".block", ".ddaml", ".txt", ".dat", ".csv"};
/// Beginnings of the names without an ending that Shi's programs give: dc and df of DDA, cv and mf of the manifold.
constexpr std::array<std::string_view, 4> kOldNames{"dc", "df", "cv", "mf"};

constexpr std::uintmax_t kMostRecord = 64U << 20U;  // bytes, as of a record that is shown
constexpr std::size_t kHeadOfCase = 4096;           // bytes, in which a case has its first key

bool is_hidden(const fs::path& name) {
  return name.string().starts_with(".") && name != "." && name != "..";
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_input(const fs::path& file) {
  if (const std::string name = lower(file.filename().string()); file.extension().empty())
    return std::ranges::any_of(kOldNames, [&](std::string_view begin) { return name.starts_with(begin); });
  return std::ranges::find(kInputs, lower(file.extension().string())) != kInputs.end();
}

enum class Record { none, sound, broken };

/// Looks at the record of a run. A file of its name may be a case: it says so by its first key.
Record record_in(const fs::path& folder) {
  static const std::regex kCaseKey("\"?keyblock\"?\\s*:");
  const fs::path file = folder / "run.json";
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(file, error))) return Record::none;
  if (fs::file_size(file, error) > kMostRecord || error) return Record::broken;
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (const Json json = sound_json(text); json.is_object())
    return json.contains("keyblock") ? Record::none : Record::sound;
  return std::regex_search(text.substr(0, kHeadOfCase), kCaseKey) ? Record::none : Record::broken;
}

/// Result in a folder.
struct Result {
  const char* kind;  ///< "run", "fos" or "sweep"
  bool is_broken = false;
};

std::optional<Result> result_in(const fs::path& folder) {
  std::error_code error;
  const Record record = record_in(folder);
  const bool is_broken = record == Record::broken;
  if (fs::exists(folder / "fos.json", error)) return Result{"fos", is_broken};
  if (study::is_of_a_sweep(folder)) return Result{"sweep", is_broken};
  const bool is_run = record != Record::none || fs::is_directory(folder / "frames", error) ||
                      fs::exists(folder / "checkpoint.h5", error);
  return is_run ? std::optional(Result{"run", is_broken}) : std::nullopt;
}

/// Returns the file that a finished result has.
const char* last_file_of(const std::string& kind) {
  return kind == "sweep" ? "table.csv" : kind == "fos" ? "fos.json" : "run.json";
}

double seconds_of(const fs::directory_entry& entry) {
  std::error_code error;
  const auto time = entry.last_write_time(error);
  if (error) return 0;
  return std::chrono::duration<double>(std::chrono::file_clock::to_sys(time).time_since_epoch()).count();
}

}  // namespace

ServedFolder::ServedFolder(const fs::path& folder) : root_(fs::canonical(folder)) {}

fs::path ServedFolder::whole(const std::string& path) const {
  const fs::path asked(path);
  if (path.empty() || path.find('\0') != std::string::npos || asked.is_absolute())
    throw NotServed("expected a path within the served folder");
  if (std::ranges::any_of(asked, [](const fs::path& part) { return is_hidden(part) || part == ".."; }))
    throw NotServed(fmt::format("{} is hidden or outside of the served folder", path));
  std::error_code error;
  const fs::path found = fs::weakly_canonical(root_ / asked, error);
  const auto [end, rest] = std::mismatch(root_.begin(), root_.end(), found.begin(), found.end());
  if (error) throw NotServed(fmt::format("no file can have this path: {}", error.message()));
  if (end != root_.end()) throw NotServed(fmt::format("{} lies outside of the served folder", path));
  if (!fs::is_directory(found.parent_path(), error))
    throw NotServed(fmt::format("there is no folder {}", asked.parent_path().generic_string()));
  return found;
}

std::string ServedFolder::name(const fs::path& whole) const {
  return whole.lexically_relative(root_).generic_string();
}

Json ServedFolder::list() const {
  Json files = Json::array(), results = Json::array();
  int unreadable = 0;
  std::error_code error;
  fs::recursive_directory_iterator at(root_, fs::directory_options::skip_permission_denied, error), end;
  for (; !error && at != end; at.increment(error)) {
    const fs::directory_entry& entry = *at;
    std::error_code of_entry;
    const std::string leaf = entry.path().filename().string();
    const bool is_readable = valid_utf8(leaf) == leaf;
    if (is_hidden(leaf) || entry.is_symlink(of_entry) || !is_readable) {
      at.disable_recursion_pending();
      if (!is_readable && (entry.is_directory(of_entry) || is_input(entry.path()))) ++unreadable;
      continue;
    }
    if (entry.is_directory(of_entry)) {
      const std::optional<Result> result = result_in(entry.path());
      if (at.depth() >= kDeepest || result) at.disable_recursion_pending();
      if (result && results.size() < kMostEntries)
        results.push_back({{"path", name(entry.path())},
                           {"kind", result->kind},
                           {"time", seconds_of(entry)},
                           {"is_broken", result->is_broken},
                           {"is_finished", fs::exists(entry.path() / last_file_of(result->kind), of_entry)},
                           {"has_checkpoint", fs::exists(entry.path() / "checkpoint.h5", of_entry)}});
    } else if (entry.is_regular_file(of_entry) && is_input(entry.path()) && !is_case_notes(entry.path()) &&
               files.size() < kMostEntries) {
      files.push_back(
          {{"path", name(entry.path())}, {"bytes", entry.file_size(of_entry)}, {"time", seconds_of(entry)}});
    }
  }
  const auto by_path = [](const Json& a, const Json& b) { return a.at("path") < b.at("path"); };
  std::sort(files.begin(), files.end(), by_path);
  std::sort(results.begin(), results.end(), by_path);
  return {{"folder", root_.filename().string()}, {"files", files}, {"results", results}, {"unreadable", unreadable}};
}

}  // namespace keyblock::serve
