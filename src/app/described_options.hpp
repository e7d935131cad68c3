// Returns the declared options of a command, for --help, man page and completion.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace keyblock {

struct DescribedOption {
  std::vector<std::string> names;  ///< "-o", "--output"; empty for arguments without a name
  std::string placeholder;         ///< "files" for arguments without a name
  std::string description;
  bool takes_value = false;
  std::vector<std::string> words = {};  ///< permitted words, if there are only such
  std::string value;                    ///< placeholder in a line of help: "joints|rock|both", "N", "FOLDER"
  std::string range;                    ///< of a number, "1 to 256"; empty if any is permitted
};

DescribedOption described(const CLI::Option& option);

/// Returns the full text of an option: its description, the range and the default of its value, its requirement, and
/// the options it goes with.
std::string sentence_of(const CLI::Option& option);

/// Returns the options of the program, or of one of its commands, in their order.
std::vector<DescribedOption> described_options(const CLI::App& app);

}  // namespace keyblock
