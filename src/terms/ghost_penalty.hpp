// Ties the polynomial of a badly cut element to that of its neighbour, so that small cuts do not make the matrix
// ill-conditioned (ghost penalty, Burman 2010). Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// Two neighbours, at least one of which is less than its triangle, and the functions of both. With near-tip functions,
/// an element at a tip is in no pair, because its field extends into no neighbour.
struct GhostPair {
  int first = 0;
  int second = 0;
  std::vector<int> functions;  ///< ascending
};

std::vector<GhostPair> ghost_pairs(const Manifold& manifold, const CoverBasis& basis);

/// Returns the pairs whose elements both stay elastic; a penalty on yielding rock would not flow with it.
std::vector<GhostPair> elastic_ghost_pairs(const Continuum& continuum, const CoverBasis& basis);

/// Adds γ M/h² ∫ (u₁ - u₂)·(v₁ - v₂) over both full triangles to K.
///
/// u₁ and u₂ are the polynomials of the two elements extended to both (Burman 2010; direct form: Preuss 2018,
/// Lehrenfeld & Olshanskii 2019). M is the modulus against strain in one direction, γ that of `stabilisation`. The
/// penalty vanishes for every field that is one polynomial of the elements' degree. It also vanishes for near-tip
/// functions, which extend beyond their elements too. A penalty on polynomials alone would prevent them from replacing
/// near-tip functions where only some covers of an element carry these.
void add_ghost_penalty(const Continuum& continuum, const CoverBasis& basis, const std::vector<GhostPair>& pairs,
                       SparseSystem& system);

}  // namespace keyblock
