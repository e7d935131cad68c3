// Reads frames from the .vtu files of a run, to draw them again. It is not a general reader of VTK: arrays have the
// coding and names of `vtu`, or are text, as earlier versions wrote them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/columns/frame_columns.hpp"
#include "formats/format.hpp"
#include "formats/views/vtk_file.hpp"
#include "problem/run_choices.hpp"
#include "result/field_frame.hpp"

namespace keyblock::formats {

/// Further array of the elements, `width` numbers for each.
struct VtuValues {
  std::string name;
  std::string unit;
  std::size_t width = 1;
  std::vector<double> values;
};

struct VtuFrame {
  FieldFrame field;          ///< without its step, which is not in the file
  std::vector<int> numbers;  ///< of the elements for the whole run, from 0
  FrameStage stage = {};
  Units units = {};                ///< from the names of arrays: "stress_xx [Pa]"; empty if they have none
  bool has_corner_stress = false;  ///< stress varies within elements
  std::vector<VtuValues> values = {};
};

/// Reads elements with displacement and stress at corners and middle; the stress of a block is that of all its corners.
/// `wanted` names further arrays of the elements; those that the file lacks are left out. If any are wanted, corners
/// get their equivalent plastic strain. Ignores other plastic states, and cracks. Throws InputError.
VtuFrame read_vtu(const Source& source, std::span<const std::string_view> wanted = {});

}  // namespace keyblock::formats
