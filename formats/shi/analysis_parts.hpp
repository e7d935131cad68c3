// Reads and writes the common parts of the native analysis files of the DDA and the manifold programs: controls, joint
// materials, stiffness.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "formats/format.hpp"
#include "formats/text/tokens.hpp"
#include "problem/analysis.hpp"

namespace keyblock::formats {

struct MaterialCounts {
  int blocks = 0;
  int joints = 0;
};

/// Returns the counts of the geometry for the points with curves in an analysis file. A drawing knows its fixed points
/// if each of its fixed lines is one point.
ReadHint counted_points(const Content& geometry);

/// Reads the head `k01 n5 nb nj g2 g1`, and adds the choices of Berkeley's reader for missing data of native files.
std::pair<Analysis, MaterialCounts> next_controls(Cursor& cursor, AnalysisDialect dialect);

/// Reads `g0` into the analysis; 0 lets the program choose, with a warning.
Warnings next_contact_stiffness(Cursor& cursor, Analysis& analysis);

/// Reads `count` block materials: the first numbers of a dialect, read by `next_head`, then initial stress, stress
/// gradient and initial velocity.
std::vector<BlockMaterial> next_block_materials(Cursor& cursor, int count,
                                                void (*next_head)(Cursor& cursor, BlockMaterial& material));
std::vector<JointMaterial> next_joint_materials(Cursor& cursor, int count);

/// Returns a curve of one row as two, for formats that require two. It holds its value to the end of time in Shi's
/// programs, or to twice its own time if that is later.
TimeCurve with_two_rows(TimeCurve curve);

/// Returns 0 without block materials.
double largest_modulus(const Analysis& analysis);

/// Writes the same parts as text; the stiffness is 0 if the program chooses the same by itself.
std::string controls_text(const Analysis& analysis);
std::string contact_stiffness_text(const Analysis& analysis);
/// Writes the numbers after the head of a block material.
std::string state_text(const BlockMaterial& material);
std::string text_of(const std::vector<JointMaterial>& materials);

}  // namespace keyblock::formats
