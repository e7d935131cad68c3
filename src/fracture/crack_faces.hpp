// Finds the faces of cracks among the edges of elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "problem/cover_plan.hpp"
#include "result/field_frame.hpp"

namespace keyblock {

/// Returns the cracks with the edges of elements along each, in the order of the elements.
std::vector<CrackFrame> with_faces(std::span<const CrackPlan> cracks, const std::vector<FieldElement>& elements);

}  // namespace keyblock
