// Names the parts of frames and tracks their files; see frame_files.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/folder/frame_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "base/bytes/sha256.hpp"
#include "base/error.hpp"
#include "formats/registry.hpp"
#include "formats/views/vtk.hpp"
#include "formats/views/vtk_parts.hpp"
#include "job/files.hpp"

namespace keyblock {

namespace fs = std::filesystem;

namespace {

/// Files of a frame, given by start and ending of their names; each is a separate part for viewers, with a name.
struct FramePart {
  std::string_view opening;
  std::string_view ending;
  std::string_view name;
};
constexpr std::array<FramePart, 5> kParts{{{"", ".vtu", "blocks"},
                                           {"contacts_", ".vtp", "contacts"},
                                           {"bolts_", ".vtp", "bolts"},
                                           {"cracks_", ".vtp", "cracks"},
                                           {"joints_", ".vtp", "joints"}}};

std::string frame_file(const FramePart& part, int step) {
  return fmt::format("{}/{}{:08}{}", kFrameFolder, part.opening, step, part.ending);
}

constexpr std::size_t kDigits = 8;  // of a step, at least

// A page that follows a run lists thousands of files per frame: paths are not taken apart into other paths.
std::string_view name_in(const fs::path& file) {
  const std::string_view path = file.native();
  return path.substr(path.rfind('/') + 1);
}

/// Returns the digits of the step in the name of a file of a part; empty for other files.
std::string_view step_in(const FramePart& part, std::string_view name) {
  if (!name.starts_with(part.opening) || !name.ends_with(part.ending)) return {};
  name.remove_prefix(part.opening.size());
  name.remove_suffix(std::min(name.size(), part.ending.size()));
  const bool is_step = name.size() >= kDigits && std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
  return is_step ? name : std::string_view();
}

int part_number(const fs::path& file) {
  const std::string_view name = name_in(file);
  const auto part = std::ranges::find_if(kParts, [&](const FramePart& p) { return !step_in(p, name).empty(); });
  return static_cast<int>(part - kParts.begin());
}

bool is_file(const fs::directory_entry& entry) {
  std::error_code error;
  return !entry.is_symlink(error) && entry.is_regular_file(error);  // known from the directory
}

/// Returns true for files that `frame_file` names; all other files there are the user's.
bool is_frame(const fs::directory_entry& entry) {
  return part_number(entry.path()) < static_cast<int>(kParts.size()) && is_file(entry);
}

}  // namespace

std::map<int, fs::path> frames_in(const fs::path& folder) {
  std::map<int, fs::path> frames;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / kFrameFolder, error)) {
    const std::string_view digits = step_in(kParts.front(), name_in(entry.path()));
    int step = 0;
    if (digits.empty() || !is_file(entry)) continue;
    if (std::from_chars(digits.data(), digits.data() + digits.size(), step).ec == std::errc())
      frames.emplace(step, entry.path());
  }
  return frames;
}

fs::path frame_file(const fs::path& folder, int step) {
  return folder / frame_file(kParts.front(), step);
}

fs::path frame_part(const fs::path& folder, std::string_view part, int step) {
  return folder / kFrameFolder / fmt::format("{}_{:08}.vtp", part, step);
}

void FrameFiles::write(const formats::FrameColumns& frame, const Units& units) {
  const formats::FrameColumns columns = formats::with_derived(frame, materials_);
  const auto& [blocks, points, lines, cracks, joints] = kParts;
  const auto has = [&](std::string_view part) { return columns.part(part).rows > 0; };
  const std::size_t first = files_.size();
  // ParaView takes from the first instant alone whether there is more than one part (5.11), so that one has contacts.
  if (first == 0 || has("contacts"))
    write(frame_file(points, frame.step), frame.time, formats::contacts_vtp(columns, units, coding_));
  if (has("contacts")) write(frame_file(joints, frame.step), frame.time, formats::joints_vtp(columns, units, coding_));
  if (has("bolts")) write(frame_file(lines, frame.step), frame.time, formats::bolts_vtp(columns, units, coding_));
  if (has("cracks")) write(frame_file(cracks, frame.step), frame.time, formats::cracks_vtp(columns, units, coding_));
  write(frame_file(blocks, frame.step), frame.time, formats::vtu(columns, units, coding_));
  std::rotate(files_.begin() + static_cast<std::ptrdiff_t>(first), files_.end() - 1, files_.end());
}

void FrameFiles::write(const std::string& name, double time, const std::string& text) {
  write_file(folder_ / name, text);
  files_.push_back({time, name, sha256(text)});
}

std::set<fs::path> FrameFiles::paths() const {
  std::set<fs::path> paths;
  for (const File& file : files_) paths.insert(folder_ / file.name);
  return paths;
}

Checksums FrameFiles::checksums(Checksums all) const {
  for (const File& file : files_) all.emplace_back(file.name, file.sha256);
  return all;
}

std::string FrameFiles::list() const {
  std::vector<formats::PvdEntry> files;
  for (const File& file : files_) {
    const int part = part_number(file.name);
    files.push_back({file.time, part, file.name, std::string(kParts.at(static_cast<std::size_t>(part)).name)});
  }
  return formats::pvd(files);
}

void FrameFiles::require_there() const {
  for (const File& file : files_)
    if (!fs::is_regular_file(folder_ / file.name))
      throw OutputError(fmt::format("{} was written, and is gone now", (folder_ / file.name).string()));
}

void FrameFiles::flush() {
  for (; flushed_ < files_.size(); ++flushed_) flush_to_disk(folder_ / files_[flushed_].name);
  flush_to_disk(folder_ / kFrameFolder);
}

void FrameFiles::remove() const {
  std::error_code error;
  for (const File& file : files_) fs::remove(folder_ / file.name, error);
}

void FrameFiles::remove_others(const fs::path& folder, const std::set<fs::path>& kept) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / kFrameFolder, error))
    if (is_frame(entry) && !kept.contains(entry.path())) files.push_back(entry.path());
  for (const fs::path& file : files) fs::remove(file, error);
  remove_drafts(folder / kFrameFolder);
}

void FrameFiles::describe(Archive& archive) {
  archive.list("files", files_, [&](File& file) {
    archive.value("time", file.time);
    archive.value("name", file.name);
    archive.value("sha256", file.sha256);
  });
  if (archive.is_restoring()) flushed_ = files_.size();
}

void FrameFiles::require_unchanged(Archive& archive) const {
  for (const File& file : files_) {
    if (!fs::is_regular_file(folder_ / file.name))
      archive.refuse(file.name, "expected every frame written so far, found one gone");
    if (sha256(formats::load((folder_ / file.name).string()).text) != file.sha256)
      archive.refuse(file.name, "expected every frame as it was written, found one changed");
  }
}

}  // namespace keyblock
