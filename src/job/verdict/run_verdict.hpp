// Gives the one verdict on a run, which its page, its report and the report of its archive show.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace keyblock {

enum class RunState {
  unfinished,  ///< there is no record
  failed,
  stopped,     ///< before its last step
  unreliable,  ///< came to its end, but checks speak against the results
  moving,
  not_equilibrium,
  no_equilibrium,
  at_rest,
  equilibrium,
  finished,  ///< the record does not judge the motion
};

struct RunVerdict {
  RunState state = RunState::unfinished;
  std::string_view words;   ///< "still moving", "stopped early"
  std::string_view tone;    ///< good, warn, bad or plain
  std::string reason = {};  ///< why the run failed, was stopped or is unreliable; may be empty
};

/// Judges a run by its record, run.json. A null record means that there is no file.
RunVerdict verdict_of(const nlohmann::ordered_json& record);

}  // namespace keyblock
