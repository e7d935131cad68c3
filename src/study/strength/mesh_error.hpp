// The error of the mesh in a factor of safety of NMM bodies, by a search on a coarser mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "study/strength/factor_of_safety.hpp"

namespace keyblock::study {

/// Finds the factor F(2h) on a mesh with sides twice as long. If errors grow with the power p of the side h, F(h) is
/// too high by (F(2h) − F(h)) / (2^p − 1) (Richardson 1911). Limit loads of elements of low order have p = 1 in the
/// limit; on meshes of practical size slopes were seen with p between 1 and 2. `found` must be bracketed. On a mesh
/// that cannot be made, if the search there fails or is stopped, or without a bracket, the result says why there is no
/// estimate.
MeshError mesh_error(const StrengthTrials& trials, const FactorOfSafety& found, SearchOptions options);

/// "mesh error about +4.1 % …".
std::string in_words(const MeshError& error);

}  // namespace keyblock::study
