// Formats the options in --help: names with their values, and sentences next to them, broken into lines.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace keyblock {

/// Replaces CLI11's own lines, which name the checks of a value and all options that exclude one another.
class HelpFormat : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
};

}  // namespace keyblock
