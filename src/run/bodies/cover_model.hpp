// Builds the model of a case with NMM bodies and contact, for dynamics or statics.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cut/bodies/cut_blocks.hpp"
#include "model/model.hpp"
#include "problem/problem.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Returns the blocks cut from a drawing, or the given ones.
CutResult blocks_of(const Problem& problem, const Settings& settings);

struct CoverModel {
  Model model;
  Warnings warnings;
};

/// Builds the model. The elements of a cover file stay as they are. With a cover plan, the bodies of a drawing or of
/// blocks are meshed. If the plan names materials, other blocks stay DDA blocks. Points keep their order. Throws
/// InputError if meshing is impossible, or if a point lies in no body.
CoverModel cover_model(const Problem& problem, const Settings& settings);

}  // namespace keyblock
