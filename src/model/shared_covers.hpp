// Elements that share covers: which nodes they hang on, and which of them form one body.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/model.hpp"

namespace keyblock {

/// Of each node, whether an element hangs on it; the others are places of covers that blocks have for themselves.
std::vector<bool> carrying_nodes(const Model& model);

/// The body of each element: elements joined by shared covers are one. Bodies count from 0 in the order of their first
/// elements.
std::vector<int> body_numbers(const Model& model);

}  // namespace keyblock
