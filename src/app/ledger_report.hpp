// The section "ledger" of run.json.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "result/ledger.hpp"

namespace keyblock {

/// The last row by name, how well the balances close that the ledger is meant to close, and all rows as one table.
/// Flows and impulses are sums since the start.
nlohmann::ordered_json ledger_json(const Ledger& ledger);

}  // namespace keyblock
