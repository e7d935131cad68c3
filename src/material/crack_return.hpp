// Computes the response of rock that yields, and of cracks in it that close: finds the crack strain that belongs to the
// stress on the yield surface.
// Theory: docs/theory/09-plasticity.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "material/yield_law.hpp"

namespace keyblock {

/// Returns the response of a law. Without a closure it is `respond_intact`.
///
/// With one, elastic strain is that of intact rock plus that of cracks, w. Stress is the response of intact rock with
/// its strength to ε - w, so it lies on the surface for every w. w is found along the principal axes by Newton's method
/// on w = w(σ(ε - w)), a piecewise linear equation for planes. If iterations alternate between sides of an edge,
/// descent with bracketed steps takes over. `is_found` is false if both end with a crack strain farther than 1e-9 of
/// the strain from that of its stress.
Response respond(const YieldLaw& law, const Eigen::Vector4d& increment, const YieldState& before, double size);

/// Returns the response under plane stress; see `respond_intact_plane_stress`.
Response respond_plane_stress(const YieldLaw& law, const Eigen::Vector3d& increment, const YieldState& before,
                              double size);

}  // namespace keyblock
