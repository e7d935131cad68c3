// Reads the frames of a result folder for the page of the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "problem/run_choices.hpp"
#include "report/page/page_frame.hpp"

namespace keyblock {

/// File of a frame, and whether the page takes its contacts.
struct ResultFrame {
  int step = 0;
  std::filesystem::path file;
  bool has_contacts = false;
};

/// Returns the frames in order. If contacts are many, only those of every n-th frame and of the last one are taken.
/// Throws InputError if there are no frames.
std::vector<ResultFrame> result_frames(const std::filesystem::path& folder);

struct ReadFrame {
  report::PageFrame frame;  ///< with bodies, contacts, bolts and cracks
  Units units = {};
};

/// Throws InputError if a file is not one that a run wrote.
ReadFrame read_result_frame(const std::filesystem::path& folder, const ResultFrame& from);

}  // namespace keyblock
