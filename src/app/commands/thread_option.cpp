// Declares `--threads` for the commands that make steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command.hpp"
#include "base/context.hpp"

namespace keyblock {

void add_thread_option(CLI::App& options) {
  options
      .add_option_function<int>(
          "--threads", [](int count) { context().use_threads(count); },
          "threads per step (default: number of processors); results do not depend on it")
      ->check(CLI::Range(1, 256));
}

}  // namespace keyblock
