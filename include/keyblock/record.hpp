// Declares runs that leave their results in a folder, as `keyblock run` does.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <keyblock/keyblock.hpp>
#include <string>
#include <vector>

namespace keyblock::api {
inline namespace v1 {

/// Results that `record` writes beside those of the case.
struct Recording {
  int every = 0;           ///< steps per frame; 0: as the case says, at most 100 frames
  bool overwrite = false;  ///< the results of an earlier run in the folder
  bool pictures = true;
  double checkpoint_every = 30;             ///< seconds; 0: none but at the start and if the run is stopped
  std::vector<std::string> histories = {};  ///< as `keyblock run --history`: "crest=point:16.8,12.8"
  std::string contacts = {};                ///< as `--contacts`: "none", "all", …; empty: as the case says
  std::string frames = "automatic";         ///< coding: "automatic", "raw", "zlib" or "text"
  /// After each step. What it throws ends the call, and passes unchanged; the run can be resumed.
  std::function<void(const Step&)> on_step = {};
};

/// Runs the case to its end with results, tables, frames and pictures in `folder`: all that `keyblock run` leaves
/// there. Throws input, choice (also for results that may not be overwritten), output if a file cannot be
/// written. A run that is stopped can be resumed.
KEYBLOCK_API Outcome record(const Case& of, const std::string& folder, const Recording& how = {},
                            const Choices& choices = {}, const Context& context = Context());
/// Continues the run that `record`, or `keyblock run`, of the same build began in `folder`. Throws input,
/// choice if there is nothing to resume.
KEYBLOCK_API Outcome resume(const std::string& folder, const std::function<void(const Step&)>& on_step = {},
                            const Context& context = Context());

/// Begins the same run, to be stepped by its caller. `Run::advance` writes all results before it returns false. Until
/// then, and if the run is dropped, the folder is that of an interrupted run. `Run::end_early`, and `go_on` with a
/// condition, end it sooner; they do not stop `context`. Throws stopped too.
KEYBLOCK_API Run recorded(const Case& of, const std::string& folder, const Recording& how = {},
                          const Choices& choices = {}, const Context& context = Context());
/// Continues the run of `resume`, to be stepped by its caller.
KEYBLOCK_API Run resumed(const std::string& folder, const Context& context = Context());

}  // namespace v1
}  // namespace keyblock::api
