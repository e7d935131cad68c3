// Adds the rows of a whole energy balance, as a run does one by one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "result/ledger.hpp"

namespace keyblock::support {

inline LedgerSums sums_of(const Ledger& ledger) {
  LedgerSums sums;
  for (const LedgerRow& row : ledger.rows) sums.add(row);
  return sums;
}

}  // namespace keyblock::support
