// Reads the frames of a run before a report relies on them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "result/field_frame.hpp"

namespace keyblock {

/// Returns one sentence on tables and frames that are gone, or differ from the checksums in the record of the run.
/// Empty if there are none. Pictures may be deleted. Throws InputError if the record cannot be read.
std::string outputs_altered(const std::filesystem::path& folder);

/// Frames of a run as they are on the disk.
struct FrameState {
  std::string fault;               ///< one sentence if results are gone, altered or unreadable; empty otherwise
  std::optional<FieldFrame> last;  ///< the last frame that can be read
};

/// Reads all frames. Results that are gone or altered are a fault too.
FrameState frames_of(const std::filesystem::path& folder);

}  // namespace keyblock
