// Makes the report of a run from what it left in its folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/handout/frame_faults.hpp"
#include "app/handout/handout.hpp"
#include "app/handout/record_reading.hpp"

namespace keyblock {

/// Verdict of a run as a client reads it.
struct Judged {
  report::Verdict verdict = report::Verdict::good;
  std::string state;  ///< "still moving"; "results damaged" if frames are faulty
  std::string words;  ///< sentences
};

/// Returns what the record says of the run; a run with faulty frames is not trusted.
Judged judged(const RunRecordFile& record, const FrameState& frames);

/// Returns "Keyblock 0.2.0", the program that ran.
std::string program_of(const RunRecordFile& record);

/// Returns pictures of a run that exist, at most `most`.
std::vector<report::DocumentPicture> run_pictures(const std::filesystem::path& folder, std::size_t most = 9);

/// Returns the report of the run in `folder`: verdict, pictures, results, bolts, contacts, assumptions, materials,
/// settings, energies, warnings, checksums. Materials are those of the input files, if these are where the run read
/// them and have not changed. Throws InputError if the folder has no record of a run.
Handout run_document(const std::filesystem::path& folder, const std::string& project);

}  // namespace keyblock
