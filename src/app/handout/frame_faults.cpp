// Collects faults, of which the first is named.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/frame_faults.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <exception>
#include <map>

#include "app/handout/record_reading.hpp"
#include "base/bytes/file_bytes.hpp"
#include "base/bytes/sha256.hpp"
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

std::string outputs_altered(const fs::path& folder) {
  if (!fs::is_regular_file(folder / kRecord)) return {};
  Faults gone, changed;
  const RunRecordFile record(folder);
  for (const auto& [name, checksum] : record.at("output_sha256").items()) {
    const fs::path file = folder / name;
    if (file.extension() == ".svg") continue;
    if (!fs::is_regular_file(file))
      gone.add(name);
    else if (checksum != sha256(file_bytes(file.string())))
      changed.add(name);
  }
  const auto told = [](const Faults& faults, const char* what) {
    return fmt::format("{} of its results {} {}; the first: {}", counted(faults.count, "file"),
                       faults.count == 1 ? "is" : "are", what, faults.first);
  };
  if (gone.count > 0) return told(gone, "gone");
  return changed.count > 0 ? told(changed, "not as the run wrote them") : std::string();
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
    state.fault = outputs_altered(folder);
  return state;
}

}  // namespace keyblock
