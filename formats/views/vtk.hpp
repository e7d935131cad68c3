// Frames for viewers such as ParaView (write only): one .vtu file a frame and one .pvd list of the files with their
// times.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// .vtu: VTK XML UnstructuredGrid, ASCII. Every block has points of its own and is one VTK_POLYGON (type 7). A block
// with holes is written as one closed chain that walks from the outer loop to each hole and back along the same line,
// for a VTK polygon has no holes. Cell data: block and material (from 1), stress_xx stress_yy stress_xy stress_zz
// (tension positive), displacement (of the centroid since the start), velocity, rotation (rad), rotation_rate, area.
// The time stands in the field TimeValue. Units are those of the input.
// Where stress varies within elements (bodies on covers) also point data, of every corner, each element its own:
// displacement, stress_xx stress_yy stress_xy stress_zz; and body (from 1) among the cell data.
// Where rock may yield (frame.plastic) also cell data, at the centroid, and with stress at corners but for the last two
// point data: plastic_strain_xx _yy _xy _zz since the start (components of the tensor, xy half of the shear angle),
// equivalent_plastic_strain (κ = ∫ √(2/3) ‖dev dεᵖ‖), mean_stress, von_mises_stress, lode_angle_degree
// (material/stress_invariants.hpp), yield_state at the end of the step (0 elastic, 1 smooth part of the surface,
// 2 edge, 3 apex, 4 tension), has_yielded since the start (0, 1); rock that cannot yield has no plastic strain.
// .pvd: VTK XML Collection; 17 significant digits of time, so that each double is told from its neighbours.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "result/field_frame.hpp"
#include "result/frame.hpp"

namespace keyblock::formats {

/// `field`: the same instant within the elements, or without elements.
std::string vtu(const Frame& frame, const FieldFrame& field = {});

/// File names are relative to the list.
std::string pvd(const std::vector<std::pair<double, std::string>>& time_and_file);

}  // namespace keyblock::formats
