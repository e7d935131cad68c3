// Writes geometry and frames for other programs: `vtk` for ParaView, `csv` for tables.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// vtk: one .vtu file with the layout of formats/views/vtk.hpp: the blocks, the elements of a cover, or the last frame
// of a replay. csv: frames as the table `blocks` of formats/text/csv.hpp; otherwise one line per corner or mark,
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

/// Parts of a content that a view leaves out: tracks, all frames except the last `frames_shown`, and items. Items have
/// the names of a case file; those of frames have the names of their members.
struct LeftOut {
  std::vector<std::string_view> items;
  std::size_t frames_shown = 0;
};

LeftOut left_out_by_vtk(const Content& content);
LeftOut left_out_by_csv(const Content& content);

}  // namespace keyblock::formats
