// Writes frames for viewers such as ParaView: one .vtu file per frame and one .pvd list of the files with their times.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// .vtu: VTK XML UnstructuredGrid (vtk_file.hpp). Velocities, areas, principal stresses, their axis and elastic strains
// are Float32. Every block has points of its own and is one VTK_POLYGON (type 7). VTK polygons have no holes. A block
// with holes is one closed chain from the outer loop to each hole and back along the same line.
// Cell data: block and material (from 1), stress_xx stress_yy stress_xy stress_zz (tension positive),
// principal_stress_greatest and _least in the plane, principal_axis (unit, of the greatest). Further cell data:
// displacement (of the centroid since the start), velocity, rotation (rad), rotation_rate, area, fixed_points (number
// of fixed points of the block). Point data, of every corner, each element its own: displacement.
// The field TimeValue has the time. Frames of stages have their name in Stage; those of load steps have IsStatic 1 and,
// if it is known, LoadFactor. Units are those of the input.
// If stress varies within elements (NMM bodies), also point data stress_xx stress_yy stress_xy stress_zz,
// principal_stress_greatest and _least, principal_axis; and body (from 1) among the cell data.
// If rock is elastoplastic (frame.plastic), also cell data at the centroid; with stress at corners all but the last two
// are also point data. plastic_strain_xx _yy _xy _zz since the start: components of the tensor, xy half of the shear
// angle. equivalent_plastic_strain: κ = ∫ √(2/3) ‖dev dεᵖ‖. mean_stress, von_mises_stress, lode_angle:
// material/stress_invariants.hpp. yield_state at the end of the step: 0 elastic, 1 smooth part of the surface, 2 edge,
// 3 apex, 4 tension. has_yielded since the start: 0, 1. Elastic rock has no plastic strain.
// If the materials are given, also elastic_strain_xx _yy _xy _zz (components of the tensor, xy half of the shear
// angle): the strain of the stress by Hooke's law of the intact rock. They are cell data and, with stress at corners,
// point data. Initial stress counts. Out of the plane the strain is 0 in plane strain without plastic strain, -nu (sxx
// + syy) / E in plane stress.
// .pvd: VTK XML Collection with names of parts; of time the fewest digits that read back equal.
#pragma once

#include <string>
#include <vector>

#include "formats/columns/frame_columns.hpp"
#include "formats/views/vtk_file.hpp"
#include "problem/run_choices.hpp"

namespace keyblock::formats {

/// Writes blocks and elements of a frame.
std::string vtu(const FrameColumns& frame, const Units& units = {}, VtkCoding coding = VtkCoding::raw);

/// File of one instant; its name is relative to the list. Files of one time differ in their part, which viewers show by
/// its name.
struct PvdEntry {
  double time = 0;
  int part = 0;
  std::string file;
  std::string name = {};  ///< of the part; empty: none
};

std::string pvd(const std::vector<PvdEntry>& entries);

/// Returns the entries of a list that `pvd` wrote; a damaged one is left out.
std::vector<PvdEntry> read_pvd(const std::string& text);

}  // namespace keyblock::formats
