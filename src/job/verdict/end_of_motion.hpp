// Reports the end of a run in terms of mechanics: at rest, in motion or in equilibrium, with displacement and speed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "job/run_record.hpp"
#include "result/frame.hpp"

namespace keyblock {

struct Prepared;

/// Kinetic energy over the largest stored energy, below which a scene is at rest.
inline constexpr double kRestEnergy = 1e-6;
/// Fraction of the steps, at the end, during which it must be below.
inline constexpr double kRestSteps = 0.1;

/// Returns the word of run.json: "at_rest", "moving", "equilibrium", "no_equilibrium", "not_equilibrium".
std::string_view word_for(MotionState state);
/// Returns the same for readers: "came to rest", "still moving", "in equilibrium", "no equilibrium", "not in
/// equilibrium".
std::string_view words_for(MotionState state);

/// Judges the end of the run; `last` is its last frame. At rest, the kinetic energy was below 1e-6 of the largest
/// stored energy in the last tenth of the steps. In addition, no block would move by a thousandth of its size in the
/// same time again. The largest stored energy counts as at least `least_energy` of `first`.
EndOfMotion end_of_motion(const Prepared& prepared, const RunRecord& record, const Frame& first, const Frame& last);

/// Returns the state with the greatest speed, without a full stop: "still moving: block 2 near …".
std::string state_in_words(const Prepared& prepared, const RunRecord& record, const EndOfMotion& end);

/// Returns the largest displacement: "block 27 near (16.8, 12.8): 0.775 mm; measured point 1: 0.754 mm".
std::string farthest_in_words(const Prepared& prepared, const RunRecord& record, const EndOfMotion& end);

/// Returns two sentences without a full stop: the state with the greatest speed; the greatest displacement. Lengths and
/// speeds name their units if the case declares them.
std::vector<std::string> sentences(const Prepared& prepared, const RunRecord& record, const EndOfMotion& end);

/// Returns `outcome.motion` of run.json.
nlohmann::ordered_json motion_json(const Prepared& prepared, const RunRecord& record, const EndOfMotion& end);

}  // namespace keyblock
