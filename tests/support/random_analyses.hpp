// Draws random analyses, each with all that its dialect can hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/format.hpp"
#include "tests/validate/dice.hpp"

namespace keyblock::support::drawn {

formats::Content berkeley_analysis(Dice& dice);
formats::Content shi_analysis(Dice& dice);
formats::Content manifold_analysis(Dice& dice);
Analysis ddaml_controls(Dice& dice);

TimeCurve curve(Dice& dice);
TimeCurve curve_or_none(Dice& dice);

}  // namespace keyblock::support::drawn
