// Rock whose cracks close and that may yield: the crack strain that goes with the stress on the yield surface.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "material/yield_law.hpp"

namespace keyblock {

/// As `respond`, or `respond_plane_stress`, of a law with a closure. Elastic strain is that of intact rock and of
/// cracks, w; stress is the answer of intact rock with its strength to ε - w, so that it lies on the surface whatever w
/// is, and w that of the stress, found along the principal axes by Newton's method on w = w(σ(ε - w)): for planes a
/// piecewise linear equation. Where rounds alternate between sides of an edge, by descent with bracketed steps.
/// `is_found` is false where both end further than 1e-9 of the strain from a crack strain of its stress.
Response respond_with_cracks(const YieldLaw& law, const Eigen::Vector4d& increment, const YieldState& before,
                             double size, bool is_plane_stress);

}  // namespace keyblock
