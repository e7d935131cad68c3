// Makes one step of Dynamics::standard: smooth motion, removal of overlaps, impacts, clean-up. Theory:
// docs/theory/03-time-integration.md and docs/theory/06-impact.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/time/step_result.hpp"

namespace keyblock {

/// Steps from `time` to `time + dt`. If contact forces do not reach their residual, the step is halved repeatedly, then
/// it fails. With few contacts the step ends at its first impact; the rest becomes a part of its own, up to four times.
/// Contacts that an impact opens therefore carry load until that instant.
StandardStep standard_step(const StandardScene& scene, const Motion& start, double time, double dt);

}  // namespace keyblock
