// Reports the initial state of a run, if it is more than that of the file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

struct StartReport {
  std::string made = "as the file has it";
  std::string balanced;    ///< carrier of the loads of t = 0, in a sentence; empty if nothing was balanced
  std::string why;         ///< reason why it is not the requested initial state; empty if it is
  double misfit = 0;       ///< compatible start: remainder of the gaps that shifts should close, relative to them
  int unsolved_steps = 0;  ///< settling: steps that found no forces and changed nothing
  /// Bodies that are suddenly loaded although an equilibrium was sought, and the reason; empty without any.
  std::string unbalanced = {};
};

}  // namespace keyblock
