// What a command line or a case of `compare` may choose on top of a cover plan: functions and fineness of the mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/problem.hpp"
#include "problem/units/measure.hpp"

namespace keyblock {

/// functions; mesh.side or mesh.half_rows (one takes the place of the other); mesh.angle; mesh.error;
/// mesh.most_unknowns. Throws std::invalid_argument with the expected values if the name or the value is not valid.
void set(CoverPlan& plan, const std::string& name, const std::string& value);

/// What a setting of the mesh measures; nothing where it is none.
std::optional<Measure> measure_of_mesh_setting(const std::string& name);

/// Returns true if `set` above knows the name: functions, contact, or one that begins with "mesh.".
bool is_of_plan(const std::string& name);

/// If the problem has a plan, takes into it the settings that `set` above knows by name: those of the case file (they
/// leave its list), then the overrides; returns the other overrides. Values may have a unit ("5 cm"), which is
/// converted to those of the case. Throws InputError for one of the case file, std::invalid_argument for an override.
std::vector<std::pair<std::string, std::string>> set_plan(
    Problem& problem, const std::vector<std::pair<std::string, std::string>>& overrides);

}  // namespace keyblock
