// Writes and lists the frame files of a run, which viewers read.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "formats/columns/frame_columns.hpp"
#include "formats/views/vtk_file.hpp"
#include "job/folder/made_by.hpp"
#include "problem/run_choices.hpp"

namespace keyblock {

inline constexpr const char* kFrameFolder = "frames";

/// Returns the files of the bodies in the folder of a run, by step.
std::map<int, std::filesystem::path> frames_in(const std::filesystem::path& folder);

/// Returns the file of the bodies at a step.
std::filesystem::path frame_file(const std::filesystem::path& folder, int step);

/// Returns the file of a part, "contacts", "joints", "bolts" or "cracks". A frame without rows of it has no
/// such file, but the first has contacts.
std::filesystem::path frame_part(const std::filesystem::path& folder, std::string_view part, int step);

/// Frame files that a run has written, in order.
class FrameFiles {
 public:
  explicit FrameFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::set<std::filesystem::path> paths() const;

  /// Writes files of contacts (at first even without any), joints, bolts and cracks if there are any, then that of the
  /// bodies: a frame that has it is whole.
  void write(const formats::FrameColumns& frame, const Units& units);
  /// Sets the materials of the bodies, which elastic strain needs. Call it before the first frame.
  void choose(std::vector<BlockMaterial> materials, formats::VtkCoding coding) {
    materials_ = std::move(materials);
    coding_ = coding;
  }
  /// Returns the checksums given, then those of the files.
  Checksums checksums(Checksums all) const;
  /// Returns the list of the files for viewers.
  std::string list() const;
  /// Throws OutputError if one of them is gone.
  void require_there() const;
  /// Flushes the files written so far to the disk.
  void flush();
  void remove() const;

  /// Removes all frame files in the folder of a run except `kept`; all other files there are the user's.
  static void remove_others(const std::filesystem::path& folder, const std::set<std::filesystem::path>& kept);

  void describe(Archive& archive);
  /// Throws InputError if a written file is gone or has changed.
  void require_unchanged(Archive& archive) const;

 private:
  struct File {
    double time = 0;
    std::string name;
    std::string sha256;
  };

  void write(const std::string& name, double time, const std::string& text);

  std::filesystem::path folder_;
  std::vector<File> files_;
  std::vector<BlockMaterial> materials_;
  formats::VtkCoding coding_ = formats::VtkCoding::automatic;
  std::size_t flushed_ = 0;
};

}  // namespace keyblock
