// Reads, checks and writes arbitrary bytes within limits of memory and time, to show that a reader withstands them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/format.hpp"

namespace keyblock::support {

/// A reader under test: that of one format, or the choice by content followed by reading (`anything`).
struct Reader {
  std::string_view name;
  const formats::Format* format = nullptr;  ///< null: by content
};

/// Returns every format of the registry that is read, then `anything`.
std::vector<Reader> all_readers();

/// Returns the reader of that name; throws std::invalid_argument if there is none.
Reader find_reader(std::string_view name);

/// Cost of one reading, without the input itself.
struct Cost {
  std::size_t bytes = 0;  ///< at its peak while reading
  double seconds = 0;     ///< of processor time, for all work
};

inline constexpr double kBytesPerByte = 20;
inline constexpr std::size_t kBytesAtLeast = 1 << 20;  ///< for any input: tables of parsers, messages
inline constexpr double kSecondsPerMegabyte = 10;
inline constexpr double kSecondsAtLeast = 1;

/// Reads and checks the result. Only InputError is caught; any other exception leaves this function.
Cost read_and_check(const Reader& reader, const std::string& text);

/// Does the same, and writes the result with every writer that accepts it. Writers may throw only
/// std::invalid_argument.
Cost exercise(const Reader& reader, const std::string& text);

/// Returns the limit that the cost exceeds, in words; empty if it keeps both. `slowdown` is that of an instrumented
/// program.
std::string excess(const Cost& cost, std::size_t size, double slowdown = 1);

}  // namespace keyblock::support
