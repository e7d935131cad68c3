// What can be asked of a run in expected.csv: the quantities by name, and their values in a frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "result/frame.hpp"

namespace keyblock::study {

/// Whose quantity it is: that of a block, or of the whole scene.
enum class Owner { block, scene };

/// True if expected.csv may ask for it.
bool is_quantity(const std::string& name, Owner owner);

/// The quantity of block `number` (from 1), or of the scene where there is none. `first` is the end of the first step, from
/// which `travel` counts: blocks have settled on each other by then, what they do later is slip.
double quantity_of(const Frame& frame, const Frame& first, const std::string& name, std::optional<int> number);

}  // namespace keyblock::study
