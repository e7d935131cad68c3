// Computes the force of the ghost penalty in a step. Like the elastic force, it conserves momentum and follows a
// rotating body. Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "system/sparse_system.hpp"

namespace keyblock {

/// Returns the force, with G of add_ghost_penalty, d_half = (d0 + d1)/2, Δ = d1 - d0 and J the quarter turn:
///       f = G d_half + (θ - ½) G (Δ - φ J d_half),   φ = (J d_half · G Δ)/(d_half · G d_half) for each body.
/// Its work is the change of ½ dᵀ G d, plus the dissipation (θ - ½) |Δ - φ J d_half|² in the norm of G. φ is the
/// rotation that explains most of Δ; without it no moment is left. G (d0 + θ Δ) would slow a rotating body whose field
/// the mesh does not represent exactly. `bodies` lists the functions of each.
Eigen::VectorXd ghost_force(const SparseSystem& ghost, const std::vector<std::vector<int>>& bodies,
                            const Eigen::VectorXd& d0, const Eigen::VectorXd& d1, double theta);

}  // namespace keyblock
