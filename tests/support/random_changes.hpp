// Changes the scene of flying bodies at random after every step, and measures the energy balance of the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/cover_plan.hpp"
#include "problem/problem.hpp"

namespace keyblock::support {

enum class ChangingBodies {
  blocks,    ///< cut in two, removed, given another material, bolted and unbolted
  meshes,    ///< and glued and unglued, given covers, a finer or coarser mesh, or made blocks again
  one_mesh,  ///< all on covers of one mesh: a strip is excavated, which parts them, or they are removed
};

/// `rows` × `rows` bodies, every other of which flies against the others, after `count` random changes.
Problem random_changes(ChangingBodies bodies, int rows, int count, unsigned seed, CoverFunctions functions);

struct ChangesTold {
  std::string why;      ///< message of an early end; empty if the last stage was reached
  std::string refused;  ///< reason if it was not begun
  std::size_t scenes = 0;
  double at_change = 0;  ///< largest change of momentum in a step that begins with a change that removes no body
  double momentum = 0;   ///< closure of the whole run
  double energy = 0;     ///< closure of the whole run
};
ChangesTold told_of_changes(const Problem& problem);

}  // namespace keyblock::support
