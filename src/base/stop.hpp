// A request to stop, as long computations hear it: between two iterations, wherever they are.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

namespace keyblock {

/// Thrown out of work that is left half done; what held before it still holds.
class StopRequested : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped by request"; }
};

/// Of the whole program, as the signals are that ask for it. May be called by a signal handler.
void request_stop();
bool is_stop_requested();

/// As if it had not been asked for.
void forget_stop_request();

/// For the loops of long computations: throws StopRequested where a stop was asked for.
void leave_if_stopped();

}  // namespace keyblock
