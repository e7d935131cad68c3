// Stops a command on Ctrl-C and similar signals; its computations notice it through their context.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock {

/// From this call on, signals that end a program (SIGINT, SIGTERM, SIGHUP, SIGXCPU) stop the context of the caller. If
/// one of the first three comes a second or more after another, it ends the program at once.
void listen_for_stops();

/// Returns true if the last signal was SIGXCPU.
bool is_at_time_limit();

}  // namespace keyblock
