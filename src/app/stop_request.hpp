// Ctrl-C and its kin ask a command to stop; its computations hear it by their context.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock {

/// From here on the signals that ask a program to end (SIGINT, SIGTERM, SIGHUP, SIGXCPU) stop the context of the
/// caller; one of the first three that comes a second or more after another of them ends the program at once.
void listen_for_stops();

/// Whether the last of them was SIGXCPU.
bool is_at_time_limit();

}  // namespace keyblock
