// Frames for viewers such as ParaView (write only): one .vtu file a frame and one .pvd list of the files with their
// times.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// .vtu: VTK XML UnstructuredGrid, ASCII. Every block has points of its own and is one VTK_POLYGON (type 7). A block
// with holes is written as one closed chain that walks from the outer loop to each hole and back along the same line,
// for a VTK polygon has no holes. Cell data: block and material (from 1), stress_xx stress_yy stress_xy (tension
// positive), displacement (of the centroid since the start), velocity, rotation (rad), rotation_rate, area. The time
// stands in the field TimeValue. Units are those of the input.
// Bodies on covers likewise, one polygon an element of the manifold, where it stood at the start; point data (of every
// corner, each element its own): displacement, stress_xx stress_yy stress_xy. Cell data: body and material (from 1),
// the same of the centroid.
// .pvd: VTK XML Collection; 17 significant digits of time, so that each double is told from its neighbours.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "result/field_frame.hpp"
#include "result/frame.hpp"

namespace keyblock::formats {

std::string vtu(const Frame& frame);
std::string vtu(const FieldFrame& frame);

/// File names are relative to the list.
std::string pvd(const std::vector<std::pair<double, std::string>>& time_and_file);

}  // namespace keyblock::formats
