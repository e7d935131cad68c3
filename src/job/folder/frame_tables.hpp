// Tables that get rows with every frame of a run: contacts, joints, joint lines and bolts.
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
#include "job/folder/growing_table.hpp"
#include "problem/output_plan.hpp"
#include "problem/run_choices.hpp"
#include "result/contact_frame.hpp"
#include "result/frame.hpp"

namespace keyblock {

/// Rows of contacts.csv, about 150 bytes each, up to which it has the contacts of every frame unless asked otherwise.
inline constexpr double kMostContactRows = 500000;

/// Which contacts of which frames go into tables and into the part of contacts for viewers.
struct ContactOutput {
  ContactTables which = ContactTables::automatic;
  int every = 1;                                            ///< frames
  std::function<bool(const ContactFrame&)> is_chosen = {};  ///< where those of histories are asked for
  int frames = 1;                                           ///< that are expected
};

class FrameTables {
 public:
  FrameTables(const std::filesystem::path& folder, const Units& units);

  /// Before the first frame.
  void choose(ContactOutput output) { output_ = std::move(output); }
  /// Of the coming frame, what viewers and contacts.csv are to have.
  ContactFrames shown(const ContactFrames& contacts) const;
  /// The rows of a frame, `shown` being those of `contacts` that are asked for.
  void append(const Frame& frame, const ContactFrames& shown, const ContactFrames& contacts);

  /// The tables of contacts have those of every n-th frame, because they would have `expected_rows` with all.
  int thinned_every() const { return std::max(thinned_every_, 1); }
  double expected_rows() const { return expected_rows_; }

  /// Saves the same as GrowingTable.
  void drop_what_followed();
  void flush() const;
  /// Names of those that have rows.
  std::vector<std::string> names() const;
  void describe(Archive& archive);

 private:
  bool is_asked() const { return output_.which != ContactTables::none && framed_ % output_.every == 0; }
  std::array<GrowingTable*, 4> all() { return {&contacts_, &joints_, &joint_lines_, &bolts_}; }
  void append_contacts(const Frame& frame, const ContactFrames& shown, const ContactFrames& contacts);

  GrowingTable contacts_;
  GrowingTable joints_;
  GrowingTable joint_lines_;
  GrowingTable bolts_;
  ContactOutput output_;
  int framed_ = 0;         ///< frames so far
  int thinned_every_ = 0;  ///< 0: there was no contact yet
  double expected_rows_ = 0;
};

}  // namespace keyblock
