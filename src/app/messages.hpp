// What goes to standard error: which messages, in which colours, and whether into a file too.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace keyblock {

/// Messages as plain lines, the words error and warning in colour on a terminal unless NO_COLOR is set (no-color.org).
void print_messages_plainly();

/// `--quiet`, `--verbose` and `--log FILE`, which take effect as they are read, for every command.
void add_message_options(CLI::App& program);

/// Prints a record that a file holds as well. If nobody reads standard output, because it is closed or its reader is
/// gone, a warning names the file. Throws OutputError if it cannot be written for another reason, as on a full disk.
void print_record(const std::string& record, const std::string& file);

/// Prints to standard error each kind once with its number, and after the kinds of a code its remedy (`  help: …`);
/// notes have no remedy there. Under --verbose prints all, each code with its remedy once.
void log_warnings(const Warnings& warnings);

/// What a run says: errors as `log_warnings`, then warnings, those of the first five codes; notes in one line that
/// counts them and names their codes. `of`: "the case", "the run". Under --verbose as `log_warnings`.
void log_by_level(const Warnings& warnings, std::string_view of);

/// Whether more than errors are to be shown.
bool shows_progress();

}  // namespace keyblock
