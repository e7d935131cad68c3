// What goes to standard error: which messages, in which colours, and whether into a file too.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace keyblock {

/// Messages as plain lines, the words error and warning in colour on a terminal unless NO_COLOR is set (no-color.org).
void print_messages_plainly();

/// `--quiet`, `--verbose` and `--log FILE`, which take effect as they are read, for every command.
void add_message_options(CLI::App& program);

/// Whether more than errors are to be shown.
bool shows_progress();

}  // namespace keyblock
