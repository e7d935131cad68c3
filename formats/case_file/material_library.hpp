// Supplies values of rock and joints by name, from tables of the literature: for a first calculation, not for design.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/analysis.hpp"
#include "problem/run_choices.hpp"

namespace keyblock::formats {

/// Puts the values of the library into the material, in the units of the case. Returns an empty text, or the expected
/// input on failure: one of the names, or declared units.
std::string take_from_library(const std::string& name, const Units& units, BlockMaterial& material);
std::string take_from_library(const std::string& name, const Units& units, JointMaterial& material);

std::vector<std::string> library_names(const BlockMaterial&);
std::vector<std::string> library_names(const JointMaterial&);

/// Returns both tables with their sources, as Markdown.
std::string library_tables();

}  // namespace keyblock::formats
