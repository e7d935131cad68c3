// Ctrl-C and its kin ask a command to stop; it looks when it can.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock {

/// From here on the signals that ask a program to end (SIGINT, SIGTERM, SIGHUP, SIGXCPU) are only remembered; a SIGINT
/// that comes seconds after another ends it.
void listen_for_stops();

/// The last of them; 0: none came.
int stop_signal();

bool is_at_time_limit();

}  // namespace keyblock
