// Computes the resultant across a line through blocks: the sum of contact and bolt forces between its two sides.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "problem/manifold.hpp"
#include "result/contact_frame.hpp"
#include "step/stepper.hpp"

namespace keyblock {

/// Resultant on all bodies to the left of the line, per unit thickness.
struct LineResultant {
  int contacts = 0;  ///< that cross the line
  int closed = 0;
  int bolts = 0;
  Point force;
  double moment = 0;  ///< about the middle of the line, counter-clockwise
};

/// Returns, per element, true if its initial centroid is to the left of the line, extended both ways.
std::vector<bool> left_of(const Segment& line, const Stepper& stepper);

/// Returns the first body of a manifold, from 0, with elements on both sides of the line between its ends; otherwise a
/// negative number. Stress acts across the line there, which no resultant includes.
int body_across(const Segment& line, const Manifold& manifold);

/// Sums contacts and bolts that lie between the ends of the line and whose elements are on different sides. `left`: by
/// the index of elements. Contacts name elements by number.
LineResultant resultant_across(const Segment& line, const Stepper& stepper, const ContactFrames& contacts);

}  // namespace keyblock
