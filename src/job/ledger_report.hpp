// Writes the section "ledger" of run.json, and ledger.csv. Theory: docs/theory/12-energy-balance.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "problem/run_choices.hpp"
#include "result/ledger.hpp"

namespace keyblock {

/// Column of the table of the energy balance.
struct LedgerColumn {
  const char* name;
  std::function<double(const LedgerRow&)> value;
};

/// Returns the columns for which a balance of this scope, with this first row, has values.
std::vector<LedgerColumn> ledger_columns(const LedgerScope& scope, const LedgerRow& start);

/// Returns the last row by name, the closures of the balances that should close, and a description of the table. The
/// table has the rows of every `kept_every`-th step, the extremes and the last. Sums and closures are of all steps.
/// Flows and impulses are sums since the start.
nlohmann::ordered_json ledger_json(const Ledger& ledger, const LedgerSums& sums, int kept_every, const Units& units);

/// Returns the rows, with the column names of `ledger_json`.
std::string ledger_csv(const Ledger& ledger, const LedgerSums& sums, const Units& units);

}  // namespace keyblock
