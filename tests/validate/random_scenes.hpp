// Draws stacks and jointed slopes by seed, for the count of converged steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "problem/problem.hpp"

namespace keyblock {

struct RandomScene {
  std::string name;  ///< "stack 17" or "slope 18": kind and seed
  Problem problem;   ///< metres, kilograms, seconds
};

inline constexpr int kFewestBlocksOfSlope = 5;
inline constexpr int kMostBlocksOfSlope = 60;

/// One to three towers side by side, 2 to 12 blocks in all, on a fixed floor that is level or falls by up to 10
/// degrees. Widths, heights, offsets, densities, moduli and friction of every joint are drawn; towers may be in
/// contact.
RandomScene random_stack(std::uint64_t seed);

/// A face of 40 to 85 degrees in rock that two joint sets cut into 5 to 60 blocks, with a fixed base and back. These
/// are two rectangles, or one L-shaped block for a quarter of the seeds. Half of the drawings merge near crossings (e0
/// = 0.005), which leaves some blocks not quite convex.
RandomScene random_slope(std::uint64_t seed);

/// Even seeds are stacks, the others slopes. The time step is 0.5, 1, 2 or 5 ms.
RandomScene random_scene(std::uint64_t seed);

/// Writes `NAME.geo` or `NAME.blk` and `NAME.ana` into an existing folder, for `keyblock run`. The native analysis file
/// has no step control: profile `legacy` needs `--set step_control=constant` to repeat a run of the problem in memory.
void write_scene(const RandomScene& scene, const std::filesystem::path& folder);

}  // namespace keyblock
