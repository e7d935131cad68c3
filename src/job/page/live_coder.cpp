// Reads frame files and lets the writer of pages code them; see live_coder.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/page/live_coder.hpp"

#include <utility>

#include "base/error.hpp"
#include "job/folder/frame_files.hpp"
#include "job/page/result_frames.hpp"

namespace keyblock {

report::PageShape LiveCoder::shape_of(int step) const {
  return read_result_frame(folder_, {step, frame_file(folder_, step), false}).frame.shape;
}

report::PageUpdate LiveCoder::update(int step, int epoch_step, bool has_contacts) {
  if (first_step_ == kNone) {
    const auto frames = frames_in(folder_);
    if (frames.empty()) throw InputError({folder_.string()}, "expected the frames of a run, found none");
    origin_ = report::origin_of(shape_of(frames.begin()->first));
    first_step_ = frames.begin()->first;
  }
  if (epoch_step_ != epoch_step) {
    shape_ = shape_of(epoch_step);
    epoch_step_ = epoch_step;
  }
  report::PageWriter page(origin_, shape_);
  page.add(read_result_frame(folder_, {step, frame_file(folder_, step), has_contacts}).frame);
  return std::move(page).update();
}

}  // namespace keyblock
