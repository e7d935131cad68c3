// The files of the frames of a run, which viewers read.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "formats/views/vtk_file.hpp"
#include "problem/run_choices.hpp"
#include "result/contact_frame.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"

namespace keyblock {

inline constexpr const char* kFrameFolder = "frames";

/// Of a run's folder the files of the bodies, by their steps.
std::map<int, std::filesystem::path> frames_in(const std::filesystem::path& folder);

/// What a run has written of them, in order.
class FrameFiles {
 public:
  explicit FrameFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  bool is_empty() const { return files_.empty(); }
  std::set<std::filesystem::path> paths() const;

  /// The bodies with `field` where that has elements, and files of contacts, bolts and cracks where there are any.
  void write(const Frame& frame, const FieldFrame& field, const ContactFrames& contacts, const Units& units);
  /// Of which bodies consist, before the first frame: for elastic strain.
  void choose(std::vector<BlockMaterial> materials, formats::VtkCoding coding) {
    materials_ = std::move(materials);
    coding_ = coding;
  }
  /// The list of them for viewers.
  std::string list() const;
  /// Throws OutputError where one is gone.
  void require_there() const;
  /// What is written so far is on the disk.
  void flush();
  void remove() const;

  /// Of those below the folder of a run all but `kept`; whatever else lies beside them is the user's.
  static void remove_others(const std::filesystem::path& folder, const std::set<std::filesystem::path>& kept);

  void describe(Archive& archive);
  /// Throws InputError where one that was written is gone or is another.
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
  formats::VtkCoding coding_ = formats::VtkCoding::raw;
  std::size_t flushed_ = 0;
};

}  // namespace keyblock
