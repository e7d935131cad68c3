// Builds the scenes of the extreme cases and runs them under profile `standard`.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "result/frame.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"

namespace keyblock::extremes {

inline constexpr double kGravity = 9.81;
/// Material of the benchmarks: density, modulus, Poisson's ratio.
inline constexpr double kDensity = 2600;
inline constexpr double kModulus = 5e9;
inline constexpr double kPoisson = 0.25;

/// Result of a run, also of one that was refused or ended early. `first` is the state before the first step.
struct Run {
  std::string
      trouble;  ///< reason for a refusal, an early end or a crash; empty if all steps were made with finite numbers
  Frame first;
  Frame before_last;  ///< one step before `last`, in runs of up to 2000 steps
  Frame last;
  int most_passes = 0;    ///< of one step
  double drawn_area = 0;  ///< of all blocks, as given or cut

  bool is_sound() const { return trouble.empty(); }
  /// Returns a block at the end; full of NaN if the run has no results.
  ElementFrame block(std::size_t index) const;
  /// Returns the displacement of its centroid since `first`.
  Point travel(std::size_t block) const;
  /// Returns the displacement of a measured point since the unloaded drawing.
  Point measured(std::size_t point) const;
};

/// Runs a problem under profile `standard`.
Run run_standard(const Problem& problem, const std::vector<Override>& overrides = {});

/// Returns a dynamic run of the default material under gravity, without friction.
Analysis plain_analysis(double dt, int steps);

BlockMaterial rock(double density, double modulus, double poissons_ratio);

BlockPolygon polygon(std::vector<Point> corners, int material = 0);
BlockPolygon rectangle(Point low, Point high, int material = 0);

/// Builds fixed and free blocks; each fixed block has two fixed points.
Blocks scene_of_blocks(std::vector<BlockPolygon> held, const std::vector<BlockPolygon>& moving);

/// Block 0: a fixed slope of 20 m that falls to the right at `slope`; block 1: a square metre on it.
Blocks block_on_slope(double slope);

/// Block 0: a fixed floor; blocks 1 … count: a tower of metre squares, with a measured point in the middle of the
/// topmost edge.
Blocks column(int count);

/// (g/2) (sin α − cos α tan φ) t², or 0 if friction holds the block.
double slide(double slope, double friction, double time);

double radians(double degrees);

}  // namespace keyblock::extremes
