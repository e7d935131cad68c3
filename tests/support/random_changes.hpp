// Bodies in flight whose scene changes at random after every step, and how well a run of them keeps its books.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/cover_plan.hpp"
#include "problem/problem.hpp"

namespace keyblock::support {

enum class ChangingBodies {
  blocks,    ///< cut in two, taken away, of another material, bolted and unbolted
  meshes,    ///< and glued and unglued, given covers, a finer or coarser mesh, or none any more
  one_mesh,  ///< all on covers of one mesh: a strip is dug through them, which parts them, or they go
};

/// `rows` × `rows` bodies, every other of which flies against the others, after `count` random changes.
Problem random_changes(ChangingBodies bodies, int rows, int count, unsigned seed, CoverFunctions functions);

struct ChangesTold {
  std::string why;      ///< it ended before its last stage; empty: it did not
  std::string refused;  ///< why it was not begun
  std::size_t scenes = 0;
  double at_change = 0;  ///< greatest change of momentum in a step that begins with a change which takes no body away
  double momentum = 0;   ///< closure of the whole run
  double energy = 0;     ///< likewise
};
ChangesTold told_of_changes(const Problem& problem);

}  // namespace keyblock::support
