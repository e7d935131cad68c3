// Judges the result of a batch job, in one word and with the reason.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/catalogue_page.hpp"

namespace keyblock::study {

/// Request for the jobs that can be read.
enum class BatchAim { check, run, convert };

/// Relative difference above which two answers do not agree.
inline constexpr double kAgreement = 0.1;

/// Returns the verdict with details:
///   "no equilibrium"  The only failures are scenes without equilibrium, as expected for a mechanism in statics. The
///                     details name the result of each profile.
///   "failed"          The first error is named.
///   "listed"          The job is not a case.
///   "read"            Nothing was run, because geometry or analysis is missing, or no run was requested.
///   "converted"       The files were converted.
///   "differs"         Two profiles disagree by more than `kAgreement`. Compared are their greatest displacements, and
///                     those of the followed point relative to the greatest. The details name amount and place.
///   "ran"             All other runs.
report::CatalogueVerdict verdict_of(const report::CatalogueRow& row, BatchAim aim);

}  // namespace keyblock::study
