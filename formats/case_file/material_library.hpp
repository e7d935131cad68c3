// Rock and joints by name: values from tables of the literature, for a first calculation and no design.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/analysis.hpp"
#include "problem/run_choices.hpp"

namespace keyblock::formats {

/// Puts the values of the library into the material, in the units of the case. Empty where that was done, else what was
/// expected: one of the names, or declared units.
std::string take_from_library(const std::string& name, const Units& units, BlockMaterial& material);
std::string take_from_library(const std::string& name, const Units& units, JointMaterial& material);

std::vector<std::string> library_names(const BlockMaterial&);
std::vector<std::string> library_names(const JointMaterial&);

/// Both tables with their sources, as Markdown.
std::string library_tables();

}  // namespace keyblock::formats
