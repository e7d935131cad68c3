// What became of a job of a batch, in one word and with the reason.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/catalogue_page.hpp"

namespace keyblock::study {

/// What was asked of the jobs that can be read.
enum class BatchAim { check, run, convert };

/// Answers that differ by more than this share of the larger do not agree.
inline constexpr double kAgreement = 0.1;

/// "no equilibrium" where a run, and none but such, ended because the scene has none, with what each profile came to:
/// the answer for a mechanism under statics; else "failed", with the first error; "listed": no case at all; "read":
/// nothing was run, because geometry or analysis is missing, or nobody asked for a run; "converted"; of a run "differs"
/// where two profiles' greatest displacements, or those of the point that is followed over the greatest anywhere, are
/// apart by more than `kAgreement`, with how much and where; else "ran".
report::CatalogueVerdict verdict_of(const report::CatalogueRow& row, BatchAim aim);

}  // namespace keyblock::study
