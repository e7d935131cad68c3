// How long a step takes, from when steps were made: the last ones count, for the first may be the hardest.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace keyblock {

/// Steps count from the first that is made here, seconds from before it, so that the first one holds the search for the
/// start.
class StepPace {
 public:
  void made(int step, double seconds) {
    last_ = {step, seconds};
    if (step == 1) later_ = last_;
    if (step < 2 * std::max(1, later_.step)) return;
    earlier_ = later_;
    later_ = last_;
  }

  /// Of the latter half to three quarters of the steps made.
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
