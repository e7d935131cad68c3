// What a run of the converted files does otherwise though they say the same: another profile, or rules of another
// dialect.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/case.hpp"

namespace keyblock::study {

/// Where no profile is asked for a run takes `legacy` for the files of old programs, whose dialect decides some of its
/// rules, and `standard` for a case file: a warning for each that changes. `after`: what is read back of the files
/// written.
Warnings changed_rules(const formats::Content& before, const formats::Content& after, const Place& place);

}  // namespace keyblock::study
