// Judges a completed run: compares it with its limits and gives the reasons for distrusting its numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "job/run_report.hpp"
#include "job/run_warnings.hpp"
#include "job/verdict/judgement.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Returns true if the energy balance of a dynamic run includes the work of all loads.
bool keeps_energy(const RunRecord& record);

/// Returns one doubt, at `place`, per limit of `TrustLimits` that the run exceeded; empty if it can be trusted. Depths
/// and crushing are those of all steps, overlap areas those of the frame `last`. Areas are compared with the unloaded
/// scene, so that overlap from the start counts; so does the displacement of a block by the start, `first`. Energy is
/// judged only for dynamic runs with an energy balance.
Judgement judged(const Prepared& prepared, const RunRecord& record, const Frame& first, const Frame& last,
                 const Place& place);

/// Puts the final judgement of a run into the record: warnings, remarks, doubts, progress of statics, end of the
/// motion. Measures, extremes and reactions are there already.
void judge(RunRecord& record, const Prepared& prepared, StepWatch& watch, const Frame& first, const Frame& last,
           const Place& place);

}  // namespace keyblock
