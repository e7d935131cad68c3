// Writes columns of a frame as arrays of a VTK file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "formats/columns/frame_columns.hpp"
#include "formats/tables/run_tables.hpp"
#include "formats/views/vtk_file.hpp"
#include "problem/run_choices.hpp"

namespace keyblock::formats {

/// Columns that a section takes.
enum class ArraysOf {
  rows,  ///< all except those of shape `ends`
  ends,  ///< only those of shape `ends`: two vectors per row
};

/// Adds the arrays that `table` declares and `part` has, in the order of the table; headings name `units`. A tensor
/// becomes four arrays, name_xx to name_zz; x and y become a vector (x, y, 0). `order`: indices of the rows to write;
/// empty: all.
void add_arrays(VtkFile& file, const FramePart& part, const RunTable& table, const Units& units, ArraysOf of,
                std::span<const std::size_t> order = {});

}  // namespace keyblock::formats
