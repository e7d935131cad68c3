// Contents drawn at random, one kind a format: whatever the format can hold may occur, sensible or not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "formats/format.hpp"
#include "tests/validate/dice.hpp"

namespace keyblock::support {

/// A format to write with, what it may hold, and what a reader must be told to read it.
struct ContentKind {
  const formats::Format* format = nullptr;
  formats::Content (*draw)(Dice&) = nullptr;
  formats::ReadHint (*hint)(const formats::Content&) = nullptr;
};

/// Every format that is written.
std::vector<ContentKind> content_kinds();

/// Writes, reads and writes again; empty where content and text came back the same, else what differs.
std::string round_trip_fault(const ContentKind& kind, const formats::Content& content);

}  // namespace keyblock::support
