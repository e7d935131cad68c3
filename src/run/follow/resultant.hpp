// What crosses a line through blocks: the sum of the forces of contacts and bolts between its two sides.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "problem/manifold.hpp"
#include "result/contact_frame.hpp"
#include "step/stepper.hpp"

namespace keyblock {

/// On all that lies to the left of the line; per unit thickness.
struct LineResultant {
  int contacts = 0;  ///< that cross
  int closed = 0;
  int bolts = 0;
  Point force;
  double moment = 0;  ///< about the middle of the line, counter-clockwise
};

/// Of each element whether its centroid lay, before any load, to the left of the line, prolonged both ways.
std::vector<bool> left_of(const Segment& line, const Stepper& stepper);

/// The first body of a manifold, from 0, with elements on both sides of the line, seen along it between its ends: what
/// one side of it does to the other is stress, which no resultant counts. Below 0: none.
int body_across(const Segment& line, const Manifold& manifold);

/// Of contacts and bolts that lie, seen along the line, between its ends, and whose elements are on different sides.
/// `left`: by the index of elements. Contacts name elements by number.
LineResultant resultant_across(const Segment& line, const Stepper& stepper, const ContactFrames& contacts);

}  // namespace keyblock
