// Prints the errors of momentum and energy under random changes of bodies in flight, a thousand of each kind. Fails if
// a run does not end, momentum is off by 1e-12 or energy by 1e-7. Runs have a hundred changes, and ten if covers have
// gradients of their own: cut ever smaller, these lose their mass in round-off, and such scenes are refused.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <vector>

#include "tests/support/continuum_scenes.hpp"

int main() {
  using namespace keyblock;
  using support::ChangingBodies;
  constexpr int kChanges = 1000;
  constexpr double kMomentum = 1e-12;
  constexpr double kEnergy = 1e-7;
  const struct {
    const char* name;
    ChangingBodies bodies;
    std::vector<CoverFunctions> functions;
  } kinds[] = {{"blocks", ChangingBodies::blocks, {CoverFunctions::derived}},
               {"meshes", ChangingBodies::meshes, {std::begin(kAllCoverFunctions), std::end(kAllCoverFunctions)}},
               {"one mesh", ChangingBodies::one_mesh, {CoverFunctions::constant, CoverFunctions::derived}}};
  int missed = 0;
  fmt::print("{:<9} {:<10} {:>7} {:>7} {:>6} {:>11} {:>11}\n", "bodies", "functions", "changes", "refused", "failed",
             "momentum", "energy");
  for (const auto& [name, bodies, all_functions] : kinds)
    for (const CoverFunctions functions : all_functions) {
      const bool has_own_gradients = functions == CoverFunctions::linear || functions == CoverFunctions::quadratic;
      const int changes = has_own_gradients ? 10 : 100;
      int failed = 0, refused = 0;
      double momentum = 0, energy = 0;
      for (unsigned seed = 1; seed <= unsigned(kChanges / changes); ++seed) {
        const support::ChangesTold told =
            support::told_of_changes(support::random_changes(bodies, 5, changes, seed, functions));
        refused += told.refused.empty() ? 0 : 1;
        if (!told.refused.empty()) continue;
        if (!told.why.empty()) fmt::print("  seed {}: scene {}: {}\n", seed, told.scenes, told.why);
        failed += told.why.empty() ? 0 : 1;
        momentum = std::max(momentum, told.at_change);
        energy = std::max(energy, told.energy);
      }
      const bool holds = failed == 0 && (has_own_gradients || refused == 0) && momentum < kMomentum && energy < kEnergy;
      missed += holds ? 0 : 1;
      fmt::print("{:<9} {:<10} {:>7} {:>7} {:>6} {:>11.1e} {:>11.1e}{}\n", name, name_of(functions), kChanges, refused,
                 failed, momentum, energy, holds ? "" : "  MISSED");
      std::fflush(stdout);
    }
  return missed > 0 ? 1 : 0;
}
