// What is shown of a state: a frame, and the points whose history is kept.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/state.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"
#include "step/stepper.hpp"

namespace keyblock {

Frame frame_of(const Model& model, const State& state, const StartPlaces& start, const Settings& settings);

/// The measured points, or the centroids where nothing is measured.
HistoryRow history_row(const Model& model, const State& state, const StartPlaces& start);

/// Gives the measured points of a frame or a row the stress of where they lie in their elements.
void put_point_stress(std::vector<PointFrame>& measured, const Model& model, const Stepper& stepper);

/// Displacement and stress at the corners of all elements now, where some hang on covers that they share; else no
/// elements.
FieldFrame field_of(const Model& model, const Stepper& stepper);

}  // namespace keyblock
