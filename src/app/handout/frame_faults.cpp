// Collects faults, of which the first is named.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/frame_faults.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <exception>
#include <map>

#include "app/handout/record_reading.hpp"
#include "base/counted.hpp"
#include "formats/registry.hpp"
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

}  // namespace

std::string outputs_gone(const fs::path& folder) {
  if (!fs::is_regular_file(folder / kRecord)) return {};
  Faults gone;
  const RunRecordFile record(folder);
  for (const auto& output : record.at("output_sha256").items())
    if (fs::path(output.key()).extension() != ".svg" && !fs::is_regular_file(folder / output.key()))
      gone.add(output.key());
  if (gone.count == 0) return {};
  return fmt::format("{} of its results {} gone; the first: {}", counted(gone.count, "file"),
                     gone.count == 1 ? "is" : "are", gone.first);
}

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
  else
    state.fault = outputs_gone(folder);
  return state;
}

}  // namespace keyblock
