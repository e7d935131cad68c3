// Applies settings of a cover plan from the command line or a case of `compare`: functions and mesh size.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/problem.hpp"
#include "problem/units/measure.hpp"

namespace keyblock {

/// Sets functions, contact, mesh.side or mesh.half_rows (one replaces the other), mesh.angle, mesh.error or
/// mesh.most_unknowns. Throws std::invalid_argument with the expected values if the name or the value is not valid.
void set(CoverPlan& plan, const std::string& name, const std::string& value);

/// Returns the quantity of a mesh setting; empty if it has none.
std::optional<Measure> measure_of_mesh_setting(const std::string& name);

/// Returns true if `set` above knows the name: functions, contact, or one that begins with "mesh.".
bool is_of_plan(const std::string& name);

/// Applies the settings known to `set` above to the plan of the problem, if it has one, and returns the other
/// overrides. Settings of the case file come first and leave its list, then the overrides. A unit in a value ("5 cm")
/// is converted to those of the case. Throws InputError for a setting of the case file, std::invalid_argument for an
/// override.
std::vector<std::pair<std::string, std::string>> set_plan(
    Problem& problem, const std::vector<std::pair<std::string, std::string>>& overrides);

}  // namespace keyblock
