// Writes files, and finds those of earlier runs by their record.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/folder/output_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/bytes/file_bytes.hpp"
#include "base/bytes/sha256.hpp"
#include "base/bytes/sound_json.hpp"
#include "base/error.hpp"
#include "formats/case.hpp"
#include "formats/registry.hpp"
#include "formats/tables/run_tables.hpp"
#include "job/folder/frame_files.hpp"

namespace keyblock {

namespace fs = std::filesystem;

namespace {

// Files that a run may leave in its folder next to its tables.
constexpr std::array<std::string_view, 11> kOtherFiles{kRecord,      kFrameList,    "picture.svg", "energy.svg",
                                                       "field.svg",  "plastic.svg", kReactionFile, "cracks.svg",
                                                       "cracks.dxf", kCheckpoint,   kPageFile};
// Tables written during the run: a killed run leaves them without a record.
constexpr std::array<const formats::RunTable*, 9> kGrowing{
    &formats::kContactsTable, &formats::kJointsTable,    &formats::kJointLinesTable,
    &formats::kBoltsTable,    &formats::kHistoriesTable, &formats::kHistoryTable,
    &formats::kPointsTable,   &formats::kStepTable,      &formats::kLedgerTable};

std::vector<std::string> growing_files() {
  std::vector<std::string> files{kFrameList};
  for (const formats::RunTable* table : kGrowing) files.emplace_back(table->file);
  return files;
}

// Recognises a page that `run --page` or `view` wrote; only the first is in the record.
bool is_page_of_run(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) &&
         file_bytes(file.string()).find("id=\"keyblock-head\"") != std::string::npos;
}

std::vector<std::string> all_files() {
  std::vector<std::string> files(kOtherFiles.begin(), kOtherFiles.end());
  for (const formats::RunTable* table : formats::run_tables())
    if (table->file != kFrameFolder) files.emplace_back(table->file);
  return files;
}

}  // namespace

OutputFiles::OutputFiles(fs::path folder, Overwrite overwrite) : folder_(std::move(folder)), overwrite_(overwrite) {
  if (fs::exists(folder_) && !fs::is_directory(folder_))
    throw UsageError(fmt::format("{} is a file, not a folder", folder_.string()));
}

void OutputFiles::require_free() const {
  for (const std::string& name : all_files()) keyblock::require_free(folder_ / name, overwrite_);
  keyblock::require_free(folder_ / kFrameFolder, overwrite_);
}

// Reads the names from the record. A run killed before it wrote one left only its checkpoint and
// growing tables.
std::set<std::string> OutputFiles::written_before() const {
  std::set<std::string> names{kRecord, kCheckpoint};
  if (is_page_of_run(folder_ / kPageFile)) names.insert(kPageFile);
  if (!fs::is_regular_file(folder_ / kRecord)) {
    if (fs::is_regular_file(folder_ / kCheckpoint))
      for (const std::string& name : growing_files()) names.insert(name);
    return names;
  }
  const auto record = sound_json(formats::load((folder_ / kRecord).string()).text);
  if (!record.is_object() || !record.contains("outputs")) return names;
  const std::vector<std::string> files = all_files();
  for (const auto& name : record.at("outputs"))
    if (name.is_string() && std::ranges::find(files, name.get<std::string>()) != files.end()) names.insert(name);
  return names;
}

void OutputFiles::remove_earlier() {
  std::error_code error;
  for (const std::string& name : written_before()) {
    fs::remove(folder_ / name, error);
    if (error) throw UsageError(fmt::format("cannot remove {} of an earlier run", (folder_ / name).string()));
  }
  FrameFiles::remove_others(folder_, {});
}

Checksums OutputFiles::checksums() const {
  Checksums all;
  for (const std::string& name : names_) {
    if (name == kPageFile) continue;
    if (!fs::is_regular_file(folder_ / name))
      throw OutputError(fmt::format("{} was written, and is gone now", (folder_ / name).string()));
    all.emplace_back(name, checksums_.at(name));
  }
  return all;
}

void OutputFiles::name(std::string_view file, std::string checksum) {
  names_.emplace_back(file);
  checksums_[std::string(file)] = std::move(checksum);
}

void OutputFiles::remove_growing() {
  std::error_code error;
  for (const std::string& name : growing_files()) fs::remove(folder_ / name, error);
}

void OutputFiles::write(std::string_view file, const std::string& text) {
  const std::string name(file);
  write_file(folder_ / name, text, own_.contains(name) ? Overwrite::yes : overwrite_);
  own_.insert(name);
  if (name != kPageFile) checksums_[name] = sha256(text);
  if (std::ranges::find(names_, name) == names_.end()) names_.push_back(name);
}

}  // namespace keyblock
