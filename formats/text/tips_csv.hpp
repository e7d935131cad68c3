// Writes the crack tips of a run as a table. Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout as in csv.hpp, one line per tip and step:
//   step,time [T],load_factor,tip,crack,end,x [L],y [L],length [L],K_I [F/L^1.5],K_II [F/L^1.5],J [F/L],
//   K_eq [F/L^1.5],kink [deg],toughness [F/L^1.5],goes_on,kind
// load_factor multiplies all loads of the file (growth). Tips count from 1 in the order of the step. Cracks count from
// 1; joints that end inside a body follow those of the file. end is 1 for the first point of the crack, 2 for the last.
// x, y are in the undeformed bodies. length is that of the whole crack (0 for a joint). K, J and kink are empty if no
// domain fits; toughness is empty if the rock has none. goes_on is 0 or 1. kind is shear for a crack that started
// in shear during growth, otherwise tension.
#pragma once

#include <string>

#include "problem/run_choices.hpp"
#include "result/history.hpp"

namespace keyblock::formats {

/// Returns an empty text if no row has a tip.
std::string tips_csv(const History& history, const Units& units = {});

}  // namespace keyblock::formats
