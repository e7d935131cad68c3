// Frames read back from the .vtu files that a run left, to draw them anew. Not a general reader of VTK: arrays are
// coded and named as `vtu` does it, or as text, as earlier versions wrote them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "formats/format.hpp"
#include "formats/views/vtk_file.hpp"
#include "problem/run_choices.hpp"
#include "result/field_frame.hpp"

namespace keyblock::formats {

struct VtuFrame {
  FieldFrame field;          ///< without its step, which the file does not tell
  std::vector<int> numbers;  ///< of the elements for the whole run, from 0
  Units units = {};          ///< by what the arrays are called: "stress_xx [Pa]"; empty where they name none
};

/// Elements with displacement and stress at corners and middle; the stress of a block is that of all its corners.
/// Plastic states and cracks are left in the file. Throws InputError.
VtuFrame read_vtu(const Source& source);

}  // namespace keyblock::formats
