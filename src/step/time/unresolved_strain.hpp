// Treats strains of blocks that are too fast for the step as quasi-static.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/bodies/standard_body.hpp"

namespace keyblock {

/// Stops the strain rates of blocks all of whose strain modes have a shorter period than a step of dt. The momenta of
/// the block stay: translation and rotation take them over. Such a mode cannot vibrate in the step. A rate left by an
/// impact would become a strain of half the rate times the step, with (ω dt)²/4 times the energy of the rate.
void stop_unresolved(const Bodies& bodies, double dt, UnknownsTable& v);

}  // namespace keyblock
