// Keeps elements that are cut small from spoiling the matrix: their field must go on in that of the neighbour.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// Two neighbours of which at least one is less than its triangle, and the functions of both. Where there are near-tip
/// functions no element at a tip is one: what it says goes on in no neighbour.
struct GhostPair {
  int first = 0;
  int second = 0;
  std::vector<int> functions;  ///< ascending
};

std::vector<GhostPair> ghost_pairs(const Manifold& manifold, const CoverBasis& basis);

/// Those whose elements both stay elastic: a penalty on yielding rock would not flow with it.
std::vector<GhostPair> elastic_ghost_pairs(const Continuum& continuum, const CoverBasis& basis);

/// K += γ M/h² ∫ (u₁ - u₂)·(v₁ - v₂) over both full triangles, u₁ and u₂ the polynomials of the two elements extended
/// to both (Burman 2010; direct form: Preuss 2018, Lehrenfeld & Olshanskii 2019); M is the modulus against strain in
/// one direction, γ that of `stabilisation`. It vanishes for every field that is one polynomial of the elements'
/// degree, and for the near-tip functions, which go on beyond their elements too: were the penalty on the polynomials
/// alone, those of elements of which some covers carry functions could not take over from them.
void add_ghost_penalty(const Continuum& continuum, const CoverBasis& basis, const std::vector<GhostPair>& pairs,
                       SparseSystem& system);

}  // namespace keyblock
