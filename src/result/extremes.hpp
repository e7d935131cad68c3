// What a run came to in a few numbers: how far anything moved, and between which stresses everything lies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include "result/field_frame.hpp"
#include "result/frame.hpp"

namespace keyblock {

/// The least and the greatest principal stress, tension positive.
std::pair<double, double> principal(const Stress& stress);

/// Of the greatest principal stress in the plane, from the x axis to the left, rad: tan 2θ = 2 σxy / (σxx − σyy) (Mohr
/// 1882).
double principal_angle(const Stress& stress);

struct Extremes {
  double displacement = 0;     ///< greatest of a corner
  int displaced_element = 0;   ///< whose vertex that is, its number from 0
  Point displaced_from = {};   ///< where that vertex was drawn, or began; of a piece without a start its centroid
  double least_stress = 0;     ///< principal, tension positive, of the mean stresses of elements
  int compressed_element = 0;  ///< number from 0
  double greatest_stress = 0;
  int stretched_element = 0;
  double area_share = 1;  ///< least area of an element over that at the start
  int crushed_element = 0;
};

/// Where the rock has flowed most, and how much of it has.
struct PlasticExtremes {
  PlasticTotals totals;
  double equivalent = 0;  ///< greatest equivalent plastic strain at the centroid of an element
  int element = 0;        ///< its number from 0
  Point place = {};       ///< of the centroid
};

/// None where no rock may yield.
std::optional<PlasticExtremes> plastic_extremes_of(const Frame& end);

/// Of the instant `end` of a run that began with `start`; elements are known by their numbers. Without any, all zero
/// and the share of area 1. `field`: the same instant within the elements, whose displacements count from where these
/// were drawn, as histories and pictures do; without elements they count from `start`, to which a start in equilibrium
/// has moved them.
Extremes extremes_of(const Frame& start, const Frame& end, const FieldFrame& field = {});

}  // namespace keyblock
