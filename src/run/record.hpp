// What is shown of a state: a frame, and the points whose history is kept.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/state.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"

namespace keyblock {

/// `start` is the state before the first step: displacements are counted from there.
Frame frame_of(const Model& model, const State& state, const State& start, const Settings& settings);

/// The measured points, or the centroids where nothing is measured.
HistoryRow history_row(const Model& model, const State& state, const State& start);

}  // namespace keyblock
