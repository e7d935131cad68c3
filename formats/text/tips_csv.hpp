// Crack tips of a run as a table.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout as in csv.hpp: step,time [T],load_factor,tip,crack,end,x [L],y [L],length [L],K_I [F/L^1.5],K_II [F/L^1.5],
// J [F/L],K_eq [F/L^1.5],kink [deg],toughness [F/L^1.5],goes_on,kind: one line a tip and step. load_factor multiplies
// all
// loads of the file (growth); tips from 1 in the order of the step; crack from 1, joints that end inside behind those
// of the file; end 1 the first point of the crack, 2 the last; x, y in the undeformed bodies; length of the whole
// crack (0 of a joint); K, J and kink are empty where no domain has room; toughness is empty where the rock has none;
// goes_on 0, 1; kind shear: of a crack that started in shear as cracks grew, else tension.
#pragma once

#include <string>

#include "problem/run_choices.hpp"
#include "result/history.hpp"

namespace keyblock::formats {

/// Empty where no row has a tip.
std::string tips_csv(const History& history, const Units& units = {});

}  // namespace keyblock::formats
