// Two numbers that may be of two moments: it is for a line of progress.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/progress/headway.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace keyblock {
namespace {

std::atomic<const char*> told_what = nullptr;
std::atomic<double> told_share = 0;

}  // namespace

void tell_headway(const char* what, double share) {
  told_share = std::clamp(share, 0.0, 1.0);
  told_what = what;
}

void forget_headway() {
  tell_headway(nullptr, 0);
}

Headway headway() {
  return {told_what, told_share};
}

double share_of_fall(double first, double now, double goal) {
  if (!(goal > 0) || !(first > goal) || !(now > 0)) return 0;
  return std::clamp(std::log(first / now) / std::log(first / goal), 0.0, 1.0);
}

}  // namespace keyblock
