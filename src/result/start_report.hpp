// How a run was started, where that is more than taking the file's word.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

struct StartReport {
  std::string made = "as the file has it";
  std::string balanced;    ///< what carries the loads of t = 0, in a sentence; empty where nothing was balanced
  std::string why;         ///< it was not the start asked for; empty if it was
  double misfit = 0;       ///< compatible start: what is left of the gaps that shifts were to close, as a share of them
  int unsolved_steps = 0;  ///< settling: steps that found no forces and changed nothing
  /// What starts suddenly though a balance of it was sought, and why; empty where nothing does.
  std::string unbalanced = {};
};

}  // namespace keyblock
