// How far a long search is, for whoever shows progress while no step ends.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock {

struct Headway {
  const char* what = nullptr;  ///< a few words; null: nothing is told
  double share = 0;            ///< of the way, up to 1; 0: not known
};

/// Of the whole program, as requests to stop are. `what` must stay where it is.
void tell_headway(const char* what, double share);
void forget_headway();
Headway headway();

/// Of the way from `first` down to `goal`, in orders of magnitude: searches that converge come evenly down that way.
double share_of_fall(double first, double now, double goal);

}  // namespace keyblock
