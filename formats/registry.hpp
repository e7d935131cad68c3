// Lists all formats, chooses the one of a file, and reads through it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "formats/format.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {

/// Returns all formats, in the order of trial.
std::span<const Format* const> all_formats();

/// Returns the format of that name; null if no format has it.
const Format* find_format(std::string_view name);

/// Loads a file from disk. Throws InputError if it is not a readable regular file.
Source load(const std::string& path);

/// Does the same. If no text begins with the first bytes of a long file, loads only these, for the error message: a
/// disk image may be larger than memory.
Source load_text(const std::string& path);

/// Format chosen for a file, and its evidence.
struct Choice {
  const Format* format = nullptr;
  Recognition recognition;
};

/// File whose numbers are split once, for the choice and for reading. Refers to the source, which must outlive it.
class Opened {
 public:
  explicit Opened(const Source& source) : source_(source) {}

  /// Equals `formats::recognise` and `formats::read_as`.
  Choice recognise(GeometryKind geometry = GeometryKind::unknown);
  Reading read_as(const Choice& choice, const ReadHint& hint = {});

 private:
  const Tokens& tokens();

  const Source& source_;
  std::optional<Tokens> tokens_;
};

/// Chooses an exact fit first, then a variant, then surplus numbers, then a similar beginning; among equals the order
/// of trial, which is that of strength. Throws InputError for an empty, binary or HTML file, and for one that fits
/// nothing. Throws it also for an analysis file that fits Shi's dialect and the NMM one equally, if the geometry does
/// not decide.
Choice recognise(const Source& source, GeometryKind geometry = GeometryKind::unknown);

/// Reads by `recognise`. Throws InputError, also for formats that are recognised only.
Reading read(const Source& source, const ReadHint& hint = {});

/// Reads with a choice already made.
Reading read_as(const Choice& choice, const Source& source, const ReadHint& hint = {});

}  // namespace keyblock::formats
