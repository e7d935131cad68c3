// Holds one instant of a run as columns: tables of numbers that writers, the library and its callers share.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts and their columns (n: one number per row; xy: two; tensor: xx, yy, xy, zz, of strain the components of the
// tensor; ends: x and y of both ends). Numbers of blocks, materials, joints and bolts count from 1, rows from 0.
//   blocks    one row per block or NMM element: block, origin, body, material, fixed_points, has_yielded, yield_state,
//             rotation (rad), rotation_rate, area, equivalent_plastic_strain (n); centroid, displacement (of the
//             centroid since the start), velocity (xy); stress, plastic_strain (tensor)
//   loops     one row per outline and hole, of blocks in their order: row (of the block), corners (their number) (n)
//   corners   one row per corner, loop after loop: row (of the block) (n); place (xy); where a field is given also
//             displacement (xy), and if stress varies within elements stress, plastic_strain,
//             equivalent_plastic_strain
//   contacts  those of contact_columns.cpp; joint is 0 without any, state 0 open, 1 sticks, 2 slides; force is that on
//             `block`
//   bolts     bolt, force (tension positive), is_broken (n); ends
//   cracks    one row per piece of a face: crack, side (0 right, 1 left), is_shear (n); ends, displacement (ends)
//   points    measured points: point (n); place, displacement (xy); stress (tensor)
//   tips      crack, at_end (1: the last point of the crack), K_I, K_II, J (NaN without a free domain), length (n);
//             place (xy, undeformed)
// Signs: tension positive in stress, pressure positive in contacts (formats/text/contact_csv.hpp).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/columns/frame_part.hpp"
#include "problem/analysis.hpp"
#include "result/contact_frame.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"

namespace keyblock::formats {

/// Stage to which a frame belongs, and the kind of its steps.
struct FrameStage {
  std::string name = {};                   ///< empty for a run without stages
  bool is_static = false;                  ///< load steps, not time steps
  std::optional<double> load_factor = {};  ///< of load steps or crack growth
};

/// All parts of one instant; those without rows have their columns too.
struct FrameColumns {
  int step = 0;
  double time = 0;
  double load_factor = 1;  ///< factor of crack growth on the loads
  std::vector<FramePart> parts;
  FrameStage stage = {};

  /// Throws std::invalid_argument if there is no such part.
  const FramePart& part(std::string_view name) const;
};

/// Returns the columns of a frame. `field`: the same instant within the elements; without elements it adds no columns.
/// `stage`: empty if only the columns are wanted.
FrameColumns columns_of(const Frame& frame, const ContactFrames& contacts, const FieldFrame& field = {},
                        FrameStage stage = {});

/// Adds derived columns of blocks, and of corners with stress: principal_stress_greatest and _least in the plane,
/// principal_axis (unit, of the greatest). Elastoplastic rock adds mean_stress, von_mises_stress, lode_angle (degree;
/// material/stress_invariants.hpp). If `materials` are given (by their numbers in the frame), adds elastic_strain by
/// Hooke's law of the intact rock. Out of the plane it is 0 in plane strain without plastic strain, -nu (sxx + syy) / E
/// in plane stress.
FrameColumns with_derived(FrameColumns frame, std::span<const BlockMaterial> materials = {});

}  // namespace keyblock::formats
