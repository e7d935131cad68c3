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

/// The last accepted step, whole: with stresses at points, reactions, plastic states and crack tips.
Frame frame_now(const Stepper& stepper);

/// Which element is pressed together most, and how far.
void put_least_area(StepReport& report, const Model& model, const State& state, const StartPlaces& start);

/// The measured points, or the centroids.
HistoryRow history_row(const Model& model, const State& state, const StartPlaces& start, bool of_measured_points);

/// Gives measured points the stress of where they lie in their elements.
void put_point_stress(Frame& frame, const Model& model, const Stepper& stepper);
void put_point_stress(HistoryRow& row, const Model& model, const Stepper& stepper);

/// Plastic state of elements and measured points, and the totals, where rock may yield; how far edges were driven.
void put_plastic(Frame& frame, const Stepper& stepper);
void put_plastic(HistoryRow& row, const Stepper& stepper, bool of_measured_points);

/// Tips of cracks of the case file and of cracks that grow, or those of joints that end in NMM bodies too.
enum class TipsOf { cracks, cracks_and_joints };

/// Crack tips with their factors; none of a stepper that knows no stress at them.
std::vector<TipState> tips_of(const Stepper& stepper, TipsOf which);

/// What each prescribed displacement exerts, where the stepper sums it.
std::vector<Point> reactions_of(const Stepper& stepper);

/// Displacement and stress at the corners of all elements now.
FieldFrame field_of(const Model& model, const Stepper& stepper);

}  // namespace keyblock
