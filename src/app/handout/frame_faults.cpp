// Collects faults, of which the first is named.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/frame_faults.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <exception>
#include <map>

#include "app/handout/record_reading.hpp"
#include "base/bytes/file_bytes.hpp"
#include "base/counted.hpp"
#include "formats/registry.hpp"
#include "formats/views/vtk.hpp"
#include "formats/views/vtu_reading.hpp"
#include "job/folder/frame_files.hpp"
#include "job/folder/output_files.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;

/// Faults of one kind.
struct Faults {
  std::size_t count = 0;
  std::string first;

  void add(const std::string& words) {
    if (count++ == 0) first = words;
  }
};

// Returns the files that the list of frames names and that are gone.
Faults missing_files(const fs::path& folder) {
  Faults missing;
  const fs::path list = folder / kFrameList;
  if (!fs::is_regular_file(list)) return missing;
  for (const formats::PvdEntry& entry : formats::read_pvd(file_bytes(list.string())))
    if (!fs::is_regular_file(folder / entry.file)) missing.add(entry.file);
  return missing;
}

bool is_list_missing(const fs::path& folder) {
  const RunRecordFile record(folder);
  for (const auto& output : record.list("outputs"))
    if (output == kFrameList) return !fs::is_regular_file(folder / kFrameList);
  return false;
}

}  // namespace

FrameState frames_of(const fs::path& folder) {
  FrameState state;
  Faults unreadable;
  const std::map<int, fs::path> frames = frames_in(folder);
  for (const auto& [step, path] : frames) try {
      state.last = formats::read_vtu(formats::load(path.string())).field;
    } catch (const std::exception& error) {
      unreadable.add(error.what());
    }
  if (unreadable.count > 0)
    state.fault = fmt::format("{} of {} cannot be read; the first: {}", unreadable.count,
                              counted(frames.size(), "frame"), unreadable.first);
  else if (const Faults missing = missing_files(folder); missing.count > 0)
    state.fault = fmt::format("{} of its frames {} gone; the first: {}", counted(missing.count, "file"),
                              missing.count == 1 ? "is" : "are", missing.first);
  else if (is_list_missing(folder))
    state.fault = fmt::format("the list of its frames, {}, is gone", kFrameList);
  return state;
}

}  // namespace keyblock
