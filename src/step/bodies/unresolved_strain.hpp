// Treats strains of blocks that are too fast for the step as quasi-static.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/bodies/standard_body.hpp"

namespace keyblock {

/// Returns true if all strain modes of a block have more than two periods in a step of dt, which does not resolve them.
bool is_unresolved(const Body& body, double dt);

/// Stops the strain rates of unresolved blocks. Translation and rotation take over their momenta. A rate left by an
/// impact would become a strain of half the rate times the step, with (ω dt)²/4 times the energy of the rate.
void stop_unresolved(const Bodies& bodies, double dt, UnknownsTable& v);

}  // namespace keyblock
