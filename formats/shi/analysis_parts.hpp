// What the native analysis files of the DDA and the manifold programs have in common: controls, joint materials,
// stiffness.
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

/// What the geometry says of the points that an analysis file has curves for. A drawing knows its fixed points where
/// each of its fixed lines is one point.
ReadHint counted_points(const Content& geometry);

/// The head `k01 n5 nb nj g2 g1`, and the choices Berkeley's reader makes for what no native file says.
std::pair<Analysis, MaterialCounts> next_controls(Cursor& cursor, AnalysisDialect dialect);

/// `g0` into the analysis; 0 means the program chooses, with a warning.
Warnings next_contact_stiffness(Cursor& cursor, Analysis& analysis);

/// `count` block materials: the numbers with which a dialect begins, read by `next_head`, then initial stress, stress
/// gradient and initial velocity.
std::vector<BlockMaterial> next_block_materials(Cursor& cursor, int count,
                                                void (*next_head)(Cursor& cursor, BlockMaterial& material));
std::vector<JointMaterial> next_joint_materials(Cursor& cursor, int count);

/// A curve of one row as two, for formats that ask for two: it holds its value to the end of the old programs' time, or
/// to twice its own where that is later.
TimeCurve with_two_rows(TimeCurve curve);

/// 0 without block materials.
double largest_modulus(const Analysis& analysis);

/// The same parts as text; the stiffness is 0 where the program chooses as it does by itself.
std::string controls_text(const Analysis& analysis);
std::string contact_stiffness_text(const Analysis& analysis);
/// What stands behind the head of a block material.
std::string state_text(const BlockMaterial& material);
std::string text_of(const std::vector<JointMaterial>& materials);

}  // namespace keyblock::formats
