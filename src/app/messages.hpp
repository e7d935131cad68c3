// Selects the messages on standard error, their colours, and a file that receives them too.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace keyblock {

/// Prints messages as plain lines. The words error and warning are in colour on a terminal unless NO_COLOR is set
/// (no-color.org).
void print_messages_plainly();

/// Adds `--quiet`, `--verbose` and `--log FILE` to every command; they take effect when they are read.
void add_message_options(CLI::App& program);

/// Prints a record that a file holds as well. If standard output is closed or its reader is gone, a warning names the
/// file. Throws OutputError if writing fails for another reason, as on a full disk.
void print_record(const std::string& record, const std::string& file);

/// Prints to standard error each kind once with its number, and after the kinds of a code its remedy (`  help: …`).
/// Notes have no remedy there. Under --verbose prints all, each code with its remedy once.
void log_warnings(const Warnings& warnings);

/// Returns the first warning of each code with the number of the others, and its remedy. Under --verbose returns all.
std::vector<std::string> lines_of(const Warnings& warnings);

/// Prints the warnings of a run: lines of the errors, then of the first five codes of warnings. One line counts the
/// notes and names their codes. `of`: "the case", "the run". Under --verbose like `log_warnings`.
void log_by_level(const Warnings& warnings, std::string_view of);

/// Returns the line of a remedy, "  help: …": lower case, no full stop.
std::string help_line(std::string_view remedy);

/// Returns true unless only errors are to be printed.
bool shows_progress();

}  // namespace keyblock
