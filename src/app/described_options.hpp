// The options of a command as they are declared, for whatever describes them: --help, man page and completion.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace keyblock {

struct DescribedOption {
  std::vector<std::string> names;  ///< "-o", "--output"; none of what stands without a name
  std::string placeholder;         ///< "files" of what stands without a name
  std::string description;
  bool takes_value = false;
  std::vector<std::string> words = {};  ///< that it may take, where only these are taken
  std::string value;                    ///< what stands for it in a line of help: "joints|rock|both", "N", "FOLDER"
  std::string range;                    ///< of a number, "1 to 256"; empty where none is asked
};

DescribedOption described(const CLI::Option& option);

/// All that is said of an option: its description, the range and the default of its value, whether it is required, and
/// what it goes with.
std::string sentence_of(const CLI::Option& option);

/// Of the program, or of one of its commands, in their order.
std::vector<DescribedOption> described_options(const CLI::App& app);

}  // namespace keyblock
