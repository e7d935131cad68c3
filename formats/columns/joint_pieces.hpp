// Sums contacts to pieces of joints: one piece per joint between two bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/columns/frame_part.hpp"

namespace keyblock::formats {

/// Returns the part `joints` of an instant, from its part `contacts`. It has one row per pair of bodies, joint and
/// joint material. Columns: block (the lower number), other, joint_material, joint (0: none); contacts, closed, sliding
/// (counts); normal_force, shear_force (sums); greatest_gap; greatest_slip (largest by magnitude, with its sign); ends.
/// The ends are the contacts that lie farthest apart along the tangent of the first one.
FramePart joint_pieces(const FramePart& contacts);

}  // namespace keyblock::formats
