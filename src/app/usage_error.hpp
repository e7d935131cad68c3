// What the user asked for cannot be done as asked (exit code 2), and results that cannot be written (exit code 4).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace keyblock {

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A disk that is full, a folder taken away during the run.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace keyblock
