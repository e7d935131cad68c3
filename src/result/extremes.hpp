// Summarises a run in a few numbers: the greatest displacement, and the range of stresses.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include "result/field_frame.hpp"
#include "result/frame.hpp"

namespace keyblock {

/// Returns the least and the greatest principal stress, tension positive.
std::pair<double, double> principal(const Stress& stress);

/// Returns the angle of the greatest principal stress in the plane, from the x axis to the left [rad]: tan 2θ = 2 σxy /
/// (σxx − σyy) (Mohr 1882).
double principal_angle(const Stress& stress);

/// Values that differ by less count as equal. The first place of equal values is named on all machines.
inline constexpr double kTie = 1e-9;

/// Returns true if a value above 0 exceeds another one by more than a tie.
bool is_clearly_greater(double value, double than);

struct Extremes {
  double displacement = 0;     ///< greatest of a corner
  int displaced_element = 0;   ///< element of that corner, its number from 0
  Point displaced_from = {};   ///< initial or drawn place of that corner; centroid of a piece without a start
  double least_stress = 0;     ///< principal, tension positive, of mean stresses of elements
  int compressed_element = 0;  ///< number from 0
  double greatest_stress = 0;
  int stretched_element = 0;
  double area_share = 1;  ///< least area of an element over that at the start
  int crushed_element = 0;
};

/// Place of the greatest plastic strain, and the totals of plastic flow.
struct PlasticExtremes {
  PlasticTotals totals;
  double equivalent = 0;  ///< greatest equivalent plastic strain at the centroid of an element
  int element = 0;        ///< its number from 0
  Point place = {};       ///< of the centroid
};

/// Returns nothing if no rock may yield.
std::optional<PlasticExtremes> plastic_extremes_of(const Frame& end);

/// Returns the extremes of the instant `end` of a run that began with `start`; elements are matched by number. Without
/// elements all are zero and the share of area is 1. `field`: the same instant within the elements. Its displacements
/// count from the drawing, as in histories and pictures. Without it they count from `start`, to which an initial
/// equilibrium has moved the elements.
Extremes extremes_of(const Frame& start, const Frame& end, const FieldFrame& field = {});

}  // namespace keyblock
