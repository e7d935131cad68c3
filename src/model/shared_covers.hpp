// Finds the nodes used by elements on covers, and the elements that form one body.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/model.hpp"

namespace keyblock {

/// Returns, per node, true if an element uses it; the others are places of covers that belong to one block alone.
std::vector<bool> carrying_nodes(const Model& model);

/// Returns the body of each element: elements connected by shared covers form one. Bodies count from 0 in the order of
/// their first elements.
std::vector<int> body_numbers(const Model& model);

}  // namespace keyblock
