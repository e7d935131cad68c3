// The model of a case with bodies on covers, for steps: with contact, in time or to equilibrium.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cut/bodies/cut_blocks.hpp"
#include "model/model.hpp"
#include "problem/problem.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// The blocks of a drawing, cut, or those that are given.
CutResult blocks_of(const Problem& problem, const Settings& settings);

struct CoverModel {
  Model model;
  Warnings warnings;
};

/// Of a cover file, elements as they are; of a drawing or blocks with a cover plan, bodies cut as the plan says: all,
/// or the blocks of the materials it names beside others that stay blocks. Points keep their order. Throws InputError
/// where the mesh cannot be, or a point lies in no body.
CoverModel cover_model(const Problem& problem, const Settings& settings);

}  // namespace keyblock
