// Draws the energies of a run over time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/run_choices.hpp"
#include "result/ledger.hpp"

namespace keyblock::report {

/// Returns an SVG document: kinetic and strain energy, gravity released, work done and energy lost, if the scene has
/// them. Without rows the page has only the title.
std::string energy_picture(const std::string& title, const Ledger& ledger, const Units& units = {});

}  // namespace keyblock::report
