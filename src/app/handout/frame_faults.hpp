// Reads the frames of a run before a report relies on them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "result/field_frame.hpp"

namespace keyblock {

/// Frames of a run as they are on the disk.
struct FrameState {
  std::string fault;               ///< one sentence if frames are gone or cannot be read; empty otherwise
  std::optional<FieldFrame> last;  ///< the last frame that can be read
};

/// Reads all frames. A frame that the list of frames names and that is gone is a fault, and so is a missing list that
/// the record names.
FrameState frames_of(const std::filesystem::path& folder);

}  // namespace keyblock
