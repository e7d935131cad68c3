// Reads the specification of a random drawing: outline, tunnels and joint sets.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The file is a JSON object of this program's own layout (the input of Shi's line programs is not known). Lengths have
// one unit, angles are in degrees, materials count from 1. Every key is optional except those marked *; unknown keys
// are rejected.
//   rectangle | slope | outline   the outline, one of them*
//     rectangle  width* height* x y         (x, y) the lower left corner, 0
//     slope      height* angle*             of the face, above 0 to 90
//                bench benches              width of the level benches, 0, and number of lifts of the face, 1
//                toe crest base             ground before the foot and behind the top, rock below the foot: height,
//                                           1.5 height, height / 2
//                x y                        the foot of the face, 0
//     outline    list of corners [x, y], in either direction; the first is not repeated
//   tunnels    list of: shape* (circle, d, horseshoe), width*, height (width), x* y* the middle
//   sets       list of:
//                dip*                       from the x axis, counter-clockwise
//                spacing*                   mean distance between rows
//                trace gap                  mean length of traces, and of the rock between those of a row (0); without
//                                           trace they go through
//                scatter                    0 to 1: standard deviation over the mean of spacing, trace, gap, and over
//                                           90 degrees of the dip: 0.1 lets the dip scatter by 9 degrees; 0
//                spacing_scatter trace_scatter gap_scatter   if one differs
//                dip_scatter_deg            standard deviation of the dip in degrees, 0 to 90; or dip_scatter, a
//                                           fraction of 90 degrees
//                distribution               of spacing, trace and gap: normal, lognormal (default), exponential
//                spacing_distribution trace_distribution gap_distribution
//                joint                      joint material: the number of the set in the list
//                seed                       that of the file
//   seed       whole number, 1
//   boundary_joint   joint material of the outline and the tunnels, 1
//   edge_node_ratio  0.001
//   fixed      list of [x1, y1, x2, y2]: fixed lines
//   measured   list of [x, y]
#pragma once

#include "formats/text/placed_json.hpp"
#include "problem/joints/joint_drawing.hpp"

namespace keyblock::formats {

/// Throws InputError for an unknown or missing key, and for an impossible value.
JointScene joint_scene_of(const PlacedJson& specification);

}  // namespace keyblock::formats
