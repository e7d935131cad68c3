// ext-06: free fall and sliding with steps from a microsecond to a second.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/extremes/extreme.hpp"
#include "tests/extremes/extreme_scenes.hpp"

namespace keyblock::extremes {
namespace {

// Steps to reach `time`, up to a limit.
int steps_to(double time, double dt, int most) {
  return std::clamp(static_cast<int>(std::lround(time / dt)), 1, most);
}

Extreme fall(double dt, int most_steps) {
  const int steps = steps_to(1, dt, most_steps);
  const double time = steps * dt;
  Problem problem;
  problem.geometry = scene_of_blocks({}, {rectangle({0, 10}, {1, 11})});
  problem.analysis = plain_analysis(dt, steps);
  const Run run = run_standard(problem);
  const double expected = kGravity / 2 * time * time;
  return {"ext-06",   fmt::format("dt {:g} s: fall in {:g} s", dt, time), expected, -run.travel(0).y, 1e-10 * expected,
          run.trouble};
}

// At 0.1 s and above Shi's programs must cut the step or warn; this test requires the answer itself.
Extreme sliding(double dt, int most_steps) {
  const int steps = steps_to(0.5, dt, most_steps);
  const double time = steps * dt;
  Problem problem;
  problem.geometry = block_on_slope(radians(30));
  problem.analysis = plain_analysis(dt, steps);
  problem.analysis->joint_materials[0].friction_angle_deg = 15;
  const Run run = run_standard(problem);
  const double expected = slide(radians(30), radians(15), time);
  return {"ext-06",        fmt::format("dt {:g} s: slide in {:g} s", dt, time),
          expected,        length(run.travel(1)),
          0.01 * expected, run.trouble};
}

}  // namespace

Extremes time_steps(Effort effort) {
  const int most_steps = effort == Effort::full ? 500'000 : 2'000;
  Extremes rows;
  for (int power = -6; power <= 0; ++power) {
    const double dt = std::pow(10.0, power);
    rows.push_back(fall(dt, most_steps));
    rows.push_back(sliding(dt, most_steps));
  }
  return rows;
}

}  // namespace keyblock::extremes
