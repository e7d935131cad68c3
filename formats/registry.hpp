// The list of every format, the choice among them for a given file, and reading through that choice.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "formats/format.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {

/// Every format, in the order of trial.
std::span<const Format* const> all_formats();

/// The format of that name; null if there is none.
const Format* find_format(std::string_view name);

/// A file on disk. Throws InputError if it is no readable regular file.
Source load(const std::string& path);

/// The same, but of a long file whose first bytes no text begins with, and which will be refused for that, these alone:
/// a disk image may be larger than memory.
Source load_text(const std::string& path);

/// The format chosen for a file, and from what.
struct Choice {
  const Format* format = nullptr;
  Recognition recognition;
};

/// A file whose numbers are split once, for the choice and for reading. Views the source: keep that alive where it is.
class Opened {
 public:
  explicit Opened(const Source& source) : source_(source) {}

  /// As `formats::recognise` and `formats::read_as`.
  Choice recognise(GeometryKind geometry = GeometryKind::unknown);
  Reading read_as(const Choice& choice, const ReadHint& hint = {});

 private:
  const Tokens& tokens();

  const Source& source_;
  std::optional<Tokens> tokens_;
};

/// An exact fit wins, then a variant, then surplus numbers, then what the file begins like; among equals the
/// order of trial, which is that of strength. Throws InputError for an empty, binary or HTML file, for one
/// that fits nothing, and for an analysis file that fits Shi's dialect and the NMM one alike, whose equations
/// are equally weak, where the geometry beside it is not known to decide.
Choice recognise(const Source& source, GeometryKind geometry = GeometryKind::unknown);

/// Reads by `recognise`. Throws InputError, also for formats that are recognised only.
Reading read(const Source& source, const ReadHint& hint = {});

/// Reads with a choice already made.
Reading read_as(const Choice& choice, const Source& source, const ReadHint& hint = {});

}  // namespace keyblock::formats
