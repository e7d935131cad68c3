// What is done with any bytes whatever to show that a reader stands them: read, check, write, within memory and time.
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

/// Every format of the registry that is read, then `anything`.
std::vector<Reader> all_readers();

/// The reader of that name; throws std::invalid_argument if there is none.
Reader find_reader(std::string_view name);

/// What one reading took, beside the input itself.
struct Cost {
  std::size_t bytes = 0;  ///< held at its peak while reading
  double seconds = 0;     ///< of processor time: all that is done
};

inline constexpr double kBytesPerByte = 20;
inline constexpr std::size_t kBytesAtLeast = 1 << 20;  ///< whatever the input: tables of parsers, messages
inline constexpr double kSecondsPerMegabyte = 10;
inline constexpr double kSecondsAtLeast = 1;

/// Reads, and checks what is read. Only InputError may come out of that; anything else leaves this function.
Cost read_and_check(const Reader& reader, const std::string& text);

/// The same; what is read is written by every writer that takes it, of which only std::invalid_argument may come.
Cost exercise(const Reader& reader, const std::string& text);

/// Which limit the cost is above, in words; empty where it keeps both. `slowdown`: of an instrumented program.
std::string excess(const Cost& cost, std::size_t size, double slowdown = 1);

}  // namespace keyblock::support
