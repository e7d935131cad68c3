// Adds the options of `run` that choose its outputs in addition to the case file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <array>

#include "job/folder/outputs_asked.hpp"

namespace keyblock {

/// Adds the options and returns them in this order: `--history`, `--contacts`, `--field`, `--frames`, `--no-pictures`,
/// `--page`.
std::array<CLI::Option*, 6> add_output_options(CLI::App& options, OutputOptions& chosen);

}  // namespace keyblock
