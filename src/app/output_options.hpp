// `--history`, `--contacts`, `--field`, `--frames` and `--no-pictures`: what a run follows, which contacts it writes,
// what its pictures show, and how its frames are coded, on top of what its case file says.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <array>

#include "job/folder/outputs_asked.hpp"

namespace keyblock {

/// `--history`, `--contacts`, `--field`, `--frames`, `--no-pictures`.
std::array<CLI::Option*, 5> add_output_options(CLI::App& options, OutputOptions& chosen);

}  // namespace keyblock
