// The list of every format, the choice among them for a given file, and reading through that choice.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "formats/format.hpp"

namespace keyblock::formats {

/// Every format, in the order of trial.
std::span<const Format* const> all_formats();

/// The format of that name; null if there is none.
const Format* find_format(std::string_view name);

/// A file on disk. Throws InputError if it is no readable regular file.
Source load(const std::string& path);

/// The format chosen for a file, and from what.
struct Choice {
  const Format* format = nullptr;
  Recognition recognition;
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
