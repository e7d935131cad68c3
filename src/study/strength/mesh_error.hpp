// Estimates the error of the mesh in a factor of safety of NMM bodies, by a search on a coarser mesh. Theory:
// docs/theory/11-strength-reduction.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "study/strength/factor_of_safety.hpp"

namespace keyblock::study {

/// Finds the factor F(2h) on a mesh with sides twice as long. If errors grow with the power p of the side h, F(h) is
/// too high by (F(2h) − F(h)) / (2^p − 1) (Richardson 1911). Limit loads of low-order elements have p = 1 in the limit;
/// slopes on practical meshes were seen with p between 1 and 2. `found` must be bracketed. If the mesh is impossible,
/// or the search there fails or stops, the result states why there is no estimate.
MeshError mesh_error(const StrengthTrials& trials, const FactorOfSafety& found, SearchOptions options);

/// Returns "mesh error about +4.1 % …".
std::string in_words(const MeshError& error);

}  // namespace keyblock::study
