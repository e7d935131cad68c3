// Writes tables of contacts and bolts over time, row by row during a run (csv.hpp has the others).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Long form: one line per contact, joint or bolt and frame; twelve significant digits. Numbers of blocks, materials and
// bolts count from 1; forces are per unit thickness; headings name the units of the case (tables/run_tables.hpp).
//   contacts  step,time and the columns of columns/contact_columns.cpp: a point of `block` against an edge or a corner
//             of `other`. joint is the joint of the drawing that made the edge, or 0; state is open, stick or slide.
//             The normal points out of `other`; the tangent is the normal rotated by +90 degrees. gap is positive if
//             the faces are apart. slip is the displacement along the tangent relative to the opposite point of the
//             other face. Both count from the positions before any load. Forces are those of the last step on `block`,
//             normal pressure positive, shear along the tangent, and their sum force_x, force_y (`other` has the
//             opposite)
//   joints    step,time,block,other,joint_material,contacts,closed,sliding,normal_force,shear_force,force_x,force_y:
//             sums over the contacts of two blocks along one joint material; the force is that on `block`, the lower
//             number
//   joint_lines  step,time,joint,joint_material,contacts,closed,sliding,normal_force,shear_force,greatest_gap,
//             greatest_slip: sums over all contacts along one joint of the drawing; pressure and shear are the same for
//             both sides
//   bolts     step,time,bolt,x1,y1,x2,y2,force,is_broken,name: both ends, tension positive; name is empty if the case
//             gives none
#pragma once

#include <string>
#include <vector>

#include "formats/columns/frame_columns.hpp"
#include "problem/run_choices.hpp"
#include "result/contact_frame.hpp"
#include "result/frame.hpp"

namespace keyblock::formats {

/// Header of a table that grows, and the lines of one instant. Sums of joints count `contacts`, all of the instant; a
/// frame has only those that tables and viewers show.
std::string contacts_csv_header(const Units& units = {});
std::string contacts_csv_rows(const FrameColumns& frame);
std::string joints_csv_header(const Units& units = {});
std::string joints_csv_rows(int step, double time, const FramePart& contacts);
std::string joint_lines_csv_header(const Units& units = {});
std::string joint_lines_csv_rows(int step, double time, const FramePart& contacts);
std::string bolts_csv_header(const Units& units = {});
/// `named`: the same bolts, for their names.
std::string bolts_csv_rows(const FrameColumns& frame, const std::vector<BoltFrame>& named);

}  // namespace keyblock::formats
