// Combines crack closure with yielding: finds the crack strain that belongs to the stress on the yield surface.
// Theory: docs/theory/09-plasticity.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "material/yield_law.hpp"

namespace keyblock {

/// Returns the response of a law with a closure, as `respond` or `respond_plane_stress` do without one.
///
/// Elastic strain is that of intact rock plus that of cracks, w. Stress is the response of intact rock with its
/// strength to ε - w, so it lies on the surface for every w. w is found along the principal axes by Newton's method on
/// w = w(σ(ε - w)), a piecewise linear equation for planes. If iterations alternate between sides of an edge, descent
/// with bracketed steps takes over. `is_found` is false if both end with a crack strain farther than 1e-9 of the strain
/// from that of its stress.
Response respond_with_cracks(const YieldLaw& law, const Eigen::Vector4d& increment, const YieldState& before,
                             double size, bool is_plane_stress);

}  // namespace keyblock
