// Computes the contact forces of blocks that have initial stress. Theory: docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Returns the contacts of faces that touch, with the forces of the initial stress σ. The stress is the mean of both
/// blocks at the contact, l the contact's part of the face and n the normal that pushes its block:
///     F = −l σ n,
/// in the limits of the joint (Cauchy's traction; constant stress over a face balances blocks of constant strain).
/// Multipliers keep what equilibrium leaves open of these forces. A spring has the force of its gap, and gets none.
ClosedContacts stressed_contacts(const StandardScene& scene, const Motion& motion);

}  // namespace keyblock
