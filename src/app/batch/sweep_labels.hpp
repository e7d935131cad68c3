// Names the keys and results of a sweep for its picture, with their units.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/run_choices.hpp"

namespace keyblock {

/// Returns "friction angle of joint material 1 [deg]" for the pointer
/// "/analysis/joint_materials/0/friction_angle_deg", "time step [s]" for a setting.
std::string label_of_key(const std::string& key, const Units& units);

/// Returns "largest displacement [m]", "factor of safety", "displacement x of crest [m]"; unknown names stay.
std::string label_of_output(const std::string& name, const Units& units);

}  // namespace keyblock
