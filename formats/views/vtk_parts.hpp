// Writes contacts, joints, bolts and cracks of a frame for viewers such as ParaView, as points and lines in addition to
// the blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// .vtp: VTK XML PolyData (vtk_file.hpp), with the time in the field TimeValue. Contacts are vertices with point data
// block, other, joint_material (from 1), state (0 open, 1 stick, 2 slide), gap, slip, normal_force, shear_force. Their
// vectors are normal (Float32) and force (on `block`; `other` has the opposite), with the signs of
// formats/text/contact_csv.hpp. Bolts are lines with cell data bolt (from 1), force (tension positive), is_broken (0,
// 1). Faces of cracks are lines in their current position. Their cell data are crack (from 1), side (0 right, 1 left
// along the crack), is_shear (0, 1: it started in shear); displacement is point data. Joints are lines from the first
// to the last contact of two bodies along one joint, with the sums of formats/columns/joint_sums.hpp as cell data.
#pragma once

#include <string>

#include "formats/columns/frame_columns.hpp"
#include "formats/views/vtk_file.hpp"
#include "problem/run_choices.hpp"

namespace keyblock::formats {

/// Precondition of all four: the part has at least one row; joints have those of contacts.
std::string contacts_vtp(const FrameColumns& frame, const Units& units = {}, VtkCoding coding = VtkCoding::raw);
std::string joints_vtp(const FrameColumns& frame, const Units& units = {}, VtkCoding coding = VtkCoding::raw);
std::string bolts_vtp(const FrameColumns& frame, const Units& units = {}, VtkCoding coding = VtkCoding::raw);
std::string cracks_vtp(const FrameColumns& frame, const Units& units = {}, VtkCoding coding = VtkCoding::raw);

}  // namespace keyblock::formats
