// Warns if a run of the converted files uses another profile or rules of another dialect, although the data are the
// same.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/case.hpp"

namespace keyblock::study {

/// Returns a warning per change. Without a requested profile a run takes `legacy` for files of Shi's programs, whose
/// dialect decides some rules, and `standard` for a case file. `after`: content of the written files, read back.
Warnings changed_rules(const formats::Content& before, const formats::Content& after, const Place& place);

}  // namespace keyblock::study
