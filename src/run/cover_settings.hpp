// What a command line or a case of `compare` may choose on top of a cover plan: functions and fineness of the mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/cover_plan.hpp"

namespace keyblock {

/// functions; mesh.side or mesh.half_rows (one takes the place of the other); mesh.angle. Throws std::invalid_argument with the
/// expected values if the name or the value is not valid.
void set(CoverPlan& plan, const std::string& name, const std::string& value);

}  // namespace keyblock
