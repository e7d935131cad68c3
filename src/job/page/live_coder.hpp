// Codes single frames of a run that goes on, for a page that shows the frames before them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "report/page/page_frame.hpp"
#include "report/page/page_writer.hpp"

namespace keyblock {

/// Keeps what frame after frame needs: the origin of the page, and the bodies of its last epoch.
class LiveCoder {
 public:
  explicit LiveCoder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Returns what a page adds to go on with the frame of `step`, see PageWriter::update. Its last epoch began at
  /// `epoch_step`. Throws InputError if one of both frames, or the first frame of the run, is gone or broken.
  report::PageUpdate update(int step, int epoch_step, bool has_contacts);

  /// Forgets the frames that were read: the run has written them anew.
  void forget() { first_step_ = epoch_step_ = kNone; }

 private:
  static constexpr int kNone = -1;

  report::PageShape shape_of(int step) const;

  std::filesystem::path folder_;
  int first_step_ = kNone;
  int epoch_step_ = kNone;
  Point origin_;
  report::PageShape shape_;
};

}  // namespace keyblock
