// Estimates the time per step from the last steps: the first may be the hardest.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace keyblock {

/// Time per step. Steps count from the first one made here, seconds from before it: the first step includes the search
/// for the initial state.
class StepPace {
 public:
  void made(int step, double seconds) {
    last_ = {step, seconds};
    if (step == 1) later_ = last_;
    if (step < 2 * std::max(1, later_.step)) return;
    earlier_ = later_;
    later_ = last_;
  }

  /// Returns the mean over the latter half to three quarters of the steps made.
  double seconds_a_step() const { return (last_.seconds - earlier_.seconds) / std::max(1, last_.step - earlier_.step); }

 private:
  struct Mark {
    int step = 0;
    double seconds = 0;
  };
  Mark earlier_;
  Mark later_;
  Mark last_;
};

}  // namespace keyblock
