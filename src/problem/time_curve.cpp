// Interpolates a time curve linearly.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/time_curve.hpp"

#include <gsl/gsl_interp.h>

namespace keyblock {

Point TimeCurve::at(double time) const {
  if (times.empty()) return {};
  if (time <= times.front()) return values.front();
  if (time >= times.back()) return values.back();
  const std::size_t row = gsl_interp_bsearch(times.data(), time, 0, times.size() - 1);
  const double share = (time - times[row]) / (times[row + 1] - times[row]);
  return values[row] + share * (values[row + 1] - values[row]);
}

double TimeCurve::last_change() const {
  for (std::size_t row = times.size(); row > 1; --row)
    if (!(values[row - 1] == values[row - 2])) return times[row - 1];
  return 0;
}

}  // namespace keyblock
