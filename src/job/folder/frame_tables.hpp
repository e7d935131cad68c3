// Appends rows to tables with every frame of a run: contacts, joints, joint lines and bolts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "formats/columns/frame_columns.hpp"
#include "job/folder/growing_table.hpp"
#include "job/folder/made_by.hpp"
#include "problem/output_plan.hpp"
#include "problem/run_choices.hpp"
#include "result/contact_frame.hpp"
#include "result/frame.hpp"

namespace keyblock {

/// Most rows of contacts.csv, about 150 bytes each, with which it has the contacts of every frame by default.
inline constexpr double kMostContactRows = 500000;

/// Selects the contacts and frames for the tables and for the contact part of the viewer files.
struct ContactOutput {
  ContactTables which = ContactTables::automatic;
  int every = 1;                                            ///< frames
  std::function<bool(const ContactFrame&)> is_chosen = {};  ///< if contacts of histories are requested
  int frames = 1;                                           ///< expected
};

class FrameTables {
 public:
  FrameTables(const std::filesystem::path& folder, const Units& units);

  /// Call it before the first frame.
  void choose(ContactOutput output) { output_ = std::move(output); }
  /// Returns the contacts of the next frame that viewers and contacts.csv get.
  ContactFrames shown(const ContactFrames& contacts) const;
  /// Appends the rows of a frame. `columns` have its requested contacts, `contacts` all.
  void append(const Frame& frame, const formats::FrameColumns& columns, const ContactFrames& contacts);

  /// Returns n if the tables have the contacts of every n-th frame only, because all frames would need `expected_rows`.
  int thinned_every() const { return std::max(thinned_every_, 1); }
  double expected_rows() const { return expected_rows_; }

  /// Drops, flushes and saves like GrowingTable.
  void drop_what_followed();
  void flush();
  /// Writes the rows that wait in memory. Returns names and checksums of the tables that have rows.
  Checksums written();
  void describe(Archive& archive);

 private:
  bool is_asked() const { return output_.which != ContactTables::none && framed_ % output_.every == 0; }
  std::array<GrowingTable*, 4> all() { return {&contacts_, &joints_, &joint_lines_, &bolts_}; }
  void append_contacts(const formats::FrameColumns& columns, const ContactFrames& contacts);

  GrowingTable contacts_;
  GrowingTable joints_;
  GrowingTable joint_lines_;
  GrowingTable bolts_;
  ContactOutput output_;
  int framed_ = 0;         ///< frames so far
  int thinned_every_ = 0;  ///< 0: no contact yet
  double expected_rows_ = 0;
};

}  // namespace keyblock
