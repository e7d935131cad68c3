// Why the numbers of a run that came to its end cannot be trusted.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "job/run_report.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// One warning for each limit of `TrustLimits` that the run went beyond, at `place`; none where it can be trusted. Energy is
/// looked at where the ledger is kept and the run is in time.
Warnings doubts(const Prepared& prepared, const RunRecord& record, const Place& place);

}  // namespace keyblock
