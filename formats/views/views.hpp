// Geometry and frames for other programs to look at (write only): `vtk` for ParaView, `csv` for tables.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// vtk: one .vtu file as formats/views/vtk.hpp lays out: the blocks, the elements of a cover, or the last frame of a
// replay. csv: frames as the table `blocks` of formats/text/csv.hpp; else one line a corner or mark,
//   kind,part,loop,x,y,material   kind: block, element, loop, joint, material_line, bolt, fixed, loading, measured or
//                                 hole; part and
//                                 loop count from 1; material is that of the edge that arrives at a block's corner, of
//                                 the edge that leaves a loop's, of the block or element else; a line takes two rows,
//                                 its ends
#pragma once

#include <string_view>
#include <vector>

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kVtk;
extern const Format kCsv;

/// What of a content a view leaves out: tracks, the frames but the last `frames_shown`, and items as a case file names
/// them; those of frames as their members are named.
struct LeftOut {
  std::vector<std::string_view> items;
  std::size_t frames_shown = 0;
};

LeftOut left_out_by_vtk(const Content& content);
LeftOut left_out_by_csv(const Content& content);

}  // namespace keyblock::formats
