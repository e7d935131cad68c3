// Makes frames and history rows from a state.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/state.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"
#include "step/stepper.hpp"

namespace keyblock {

Frame frame_of(const Model& model, const State& state, const StartPlaces& start, const Settings& settings);

/// Returns the full frame of the last accepted step: with stresses at points, reactions, plastic states and crack tips.
Frame frame_now(const Stepper& stepper);

/// Sets the most compressed element and its ratio of areas.
void put_least_area(StepReport& report, const Model& model, const State& state, const StartPlaces& start);

/// Returns the row of the measured points, or of the centroids.
HistoryRow history_row(const Model& model, const State& state, const StartPlaces& start, bool of_measured_points);

/// Sets the stress of measured points, at their positions in their elements.
void put_point_stress(Frame& frame, const Model& model, const Stepper& stepper);
void put_point_stress(HistoryRow& row, const Model& model, const Stepper& stepper);

/// Sets the plastic state of elements and measured points, and the totals, of elastoplastic rock; also the displacement
/// of driven edges.
void put_plastic(Frame& frame, const Stepper& stepper);
void put_plastic(HistoryRow& row, const Stepper& stepper, bool of_measured_points);

/// Choice of crack tips: cracks of the case file and growing cracks only, or also joints that end in NMM bodies.
enum class TipsOf { cracks, cracks_and_joints };

/// Returns crack tips with their stress intensity factors; empty if the stepper has no stress at them.
std::vector<TipState> tips_of(const Stepper& stepper, TipsOf which);

/// Returns the reaction of each prescribed displacement, if the stepper computes it.
std::vector<Point> reactions_of(const Stepper& stepper);

/// Returns current displacement and stress at the corners of all elements.
FieldFrame field_of(const Model& model, const Stepper& stepper);

}  // namespace keyblock
