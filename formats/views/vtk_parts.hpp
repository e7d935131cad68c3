// Contacts and bolts of a frame for viewers such as ParaView (write only): files of points and lines beside the blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// .vtp: VTK XML PolyData (vtk_file.hpp), the time in the field TimeValue. Contacts are vertices with point data block,
// other, joint_material (from 1), state (0 open, 1 stick, 2 slide), gap, slip, normal_force, shear_force, and as
// vectors normal (Float32), force (on `block`; `other` has the opposite): signs as in formats/text/contact_csv.hpp.
// Bolts are lines with cell data bolt (from 1), force (tension positive), is_broken (0, 1). Faces of cracks are lines
// where they are now, with cell data crack (from 1), side (0 the right one of the way along the crack, 1 the left one),
// is_shear (0, 1: it started in shear) and point data displacement.
#pragma once

#include <string>

#include "formats/columns/frame_columns.hpp"
#include "formats/views/vtk_file.hpp"
#include "problem/run_choices.hpp"

namespace keyblock::formats {

/// Each needs at least one row of its part.
std::string contacts_vtp(const FrameColumns& frame, const Units& units = {}, VtkCoding coding = VtkCoding::raw);
std::string bolts_vtp(const FrameColumns& frame, const Units& units = {}, VtkCoding coding = VtkCoding::raw);
std::string cracks_vtp(const FrameColumns& frame, const Units& units = {}, VtkCoding coding = VtkCoding::raw);

}  // namespace keyblock::formats
