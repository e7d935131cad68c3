// Why the numbers of a run that came to its end cannot be trusted.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "job/run_report.hpp"
#include "job/run_warnings.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Returns true if the energy balance of a run in time knows the work of all loads.
bool keeps_energy(const RunRecord& record);

struct Judgement {
  Warnings doubts;   ///< why the results are not to be trusted
  Warnings remarks;  ///< what could not be looked at
};

/// One doubt for each limit of `TrustLimits` that the run went beyond, at `place`; none where it can be trusted. Depths
/// and crushing are those of all steps, areas in common those at the end `last`; areas are held against the unloaded
/// scene, so that what the start pressed counts, and so does how far it moved a block, `first`. Energy is looked at
/// where the ledger is kept and the run is in time.
Judgement judged(const Prepared& prepared, const RunRecord& record, const Frame& first, const Frame& last,
                 const Place& place);

/// Puts what is to be said of a run at its end into the record: warnings, remarks, doubts, how far statics came, how
/// the motion ended. Measures, extremes and reactions are there already.
void judge(RunRecord& record, const Prepared& prepared, StepWatch& watch, const Frame& first, const Frame& last,
           const Place& place);

}  // namespace keyblock
