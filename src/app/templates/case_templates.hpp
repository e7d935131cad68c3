// Declares the commented example cases.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

namespace keyblock {

struct CaseTemplate {
  const char* name;
  const char* about;  ///< one phrase
  const char* text;   ///< a case file
};

std::span<const CaseTemplate> case_templates();

}  // namespace keyblock
