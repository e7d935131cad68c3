// Draws random contents, one kind per format. They may hold all that the format can hold, sensible or not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "formats/format.hpp"
#include "tests/validate/dice.hpp"

namespace keyblock::support {

/// A format to write with, its possible contents, and the options that a reader needs.
struct ContentKind {
  const formats::Format* format = nullptr;
  formats::Content (*draw)(Dice&) = nullptr;
  formats::ReadHint (*hint)(const formats::Content&) = nullptr;
};

/// Returns every format that is written.
std::vector<ContentKind> content_kinds();

/// Writes, reads and writes again. Returns the difference of contents or texts; empty if both agree.
std::string round_trip_fault(const ContentKind& kind, const formats::Content& content);

}  // namespace keyblock::support
