// Prints how many steps of random stacks and slopes converge without cutting, under both profiles, and fails below the share asked.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdlib>
#include <thread>

#include "tests/validate/convergence.hpp"

int main(int count, char** words) {
  using namespace keyblock;
  const std::uint64_t first = count > 1 ? std::strtoull(words[1], nullptr, 10) : 0;
  const int scenes = count > 2 ? std::atoi(words[2]) : 1000;
  const int threads = count > 3 ? std::atoi(words[3]) : 2;
  fmt::print("scene;profile;end;blocks;dt;asked;made;plain;fallback;cut;cut_here;unsettled;passes;maxres;seconds;excess;gain;ratio;rise;area;reason\n");
  for (const SceneRun& r : run_scenes(first, scenes, threads)) {
    double res = 0;
    for (double x : r.residuals) res = std::max(res, x);
    fmt::print("{};{};{};{};{};{};{};{};{};{};{};{};{};{:.2e};{:.2f};{:.2e};{:.2e};{:.3f};{:.2e};{:.2e};{}\n", r.scene, r.profile, static_cast<int>(r.end), r.blocks, r.time_step, r.asked, r.made, r.plain, r.with_fallback, r.cut, r.cut_here, r.unsettled, r.passes, res, r.seconds, r.energy_excess, r.energy_gain, r.energy_ratio, r.rise, r.area_change, r.reason);
  }
}
