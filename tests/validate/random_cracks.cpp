// Cuts, solves and moves a thousand scenes with random cracks. Prints the errors of area, balance and momentum. Fails
// if a scene fails, area is off by 1e-12, the residual or momentum by 1e-10, or a domain about a tip is refused without
// a reason. `free`: the cracks cut off an unsupported piece, and statics report it; `unfit`: linear covers are refused
// in flight, a piece being too thin for their mass. Angular momentum over steps and energy are printed beside it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_cracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  using namespace keyblock;
  using namespace keyblock::support;
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
  const int each = (count + kCrackKinds - 1) / kCrackKinds;
  int missed = 0;
  fmt::print("{:<15} {:>6} {:>7} {:>6} {:>5} {:>5} {:>5} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "cracks",
             "scenes", "refused", "failed", "free", "unfit", "tips", "domains", "refused", "area", "residual",
             "carried", "linear", "angular", "energy");
  for (int kind = 0; kind < kCrackKinds; ++kind) {
    CracksTold sum;
    int refused = 0, failed = 0, free = 0, unfit = 0;
    for (unsigned seed = 1; seed <= static_cast<unsigned>(each); ++seed) {
      const CracksTold told = told_of_cracks(random_cracks(static_cast<CrackKind>(kind), seed));
      if (!told.refused.empty()) fmt::print("  seed {}: refused: {}\n", seed, told.refused);
      for (const std::string& why : told.failed) fmt::print("  seed {}: {}\n", seed, why);
      refused += told.refused.empty() ? 0 : 1;
      failed += told.failed.empty() ? 0 : 1;
      free += told.has_free_piece ? 1 : 0;
      unfit += told.unfit_to_fly ? 1 : 0;
      sum.tips += told.tips;
      sum.domains += told.domains;
      sum.refused_domains += told.refused_domains;
      sum.area = std::max(sum.area, told.area);
      sum.residual = std::max(sum.residual, told.residual);
      sum.carried = std::max(sum.carried, told.carried);
      sum.linear = std::max(sum.linear, told.linear);
      sum.angular = std::max(sum.angular, told.angular);
      sum.energy = std::max(sum.energy, told.energy);
    }
    const bool holds = refused == 0 && failed == 0 && sum.area < 1e-12 && sum.residual < 1e-10 && sum.carried < 1e-10 &&
                       sum.linear < 1e-10;
    missed += holds ? 0 : 1;
    fmt::print(
        "{:<15} {:>6} {:>7} {:>6} {:>5} {:>5} {:>5} {:>8} {:>8} {:>8.1e} {:>8.1e} {:>8.1e} {:>8.1e} {:>8.1e} "
        "{:>8.1e}{}\n",
        name_of(static_cast<CrackKind>(kind)), each, refused, failed, free, unfit, sum.tips, sum.domains,
        sum.refused_domains, sum.area, sum.residual, sum.carried, sum.linear, sum.angular, sum.energy,
        holds ? "" : "  MISSED");
    std::fflush(stdout);
  }
  return missed > 0 ? 1 : 0;
}
