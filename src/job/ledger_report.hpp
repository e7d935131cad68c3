// The section "ledger" of run.json.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "result/ledger.hpp"

namespace keyblock {

/// The last row by name, how well the balances close that the ledger is meant to close, and the rows kept of every
/// `kept_every`-th step, extremes and the last as one table. Sums and closures are of all steps.
/// Flows and impulses are sums since the start.
nlohmann::ordered_json ledger_json(const Ledger& ledger, const LedgerSums& sums, int kept_every);

}  // namespace keyblock
