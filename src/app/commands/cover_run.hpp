// `keyblock run` of bodies on covers: load steps to frames, tables, a picture and run.json.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/exit_code.hpp"
#include "formats/case.hpp"
#include "job/files.hpp"
#include "job/run_report.hpp"
#include "run/cover_case.hpp"

namespace keyblock {

struct CoverRunRequest {
  std::string title;
  std::string profile;
  std::vector<Override> overrides;
  std::string folder;
  Overwrite overwrite = Overwrite::no;
  bool as_json = false;
  std::vector<InputRecord> inputs;
  double seconds_read = 0;
};

/// Basis, unknowns, elements, covers: for `check` and run.json.
nlohmann::ordered_json counts_json(const CoverCounts& counts);
std::string sentence_of(const CoverCounts& counts);

/// Throws as CoverCase does.
ExitCode run_covers(const formats::Case& loaded, const CoverRunRequest& request);

}  // namespace keyblock
