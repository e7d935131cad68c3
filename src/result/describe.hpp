// Describes the reports of runs as members to save and restore.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/archive.hpp"
#include "result/crack_notes.hpp"
#include "result/force_balance.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"
#include "result/ledger.hpp"
#include "result/step_record.hpp"

namespace keyblock {

void describe(Archive& archive, Frame& frame);
void describe(Archive& archive, HistoryRow& row);
void describe(Archive& archive, TipState& tip);
void describe(Archive& archive, CrackNotes& notes);
void describe(Archive& archive, LedgerRow& row);
void describe(Archive& archive, LedgerSums& sums);
void describe(Archive& archive, StepTotals& totals);
void describe(Archive& archive, StepReport& report);
void describe(Archive& archive, ForceBalance& balance);

}  // namespace keyblock
