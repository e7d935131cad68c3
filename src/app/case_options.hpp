// The options by which every command takes a case: its files, a table of layers, profile and settings.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "study/cases/asked_case.hpp"

namespace keyblock {

struct CaseOptions {
  std::vector<std::string> paths;
  std::string profile;
  std::vector<std::string> sets;
  std::string settings_file;
  std::string layers;  ///< file
};

/// What was added, for commands that exclude some of them from others.
struct CaseOptionList {
  CLI::Option* files;
  CLI::Option* profile;
  CLI::Option* sets;
  CLI::Option* settings_file;
  CLI::Option* layers;
};

/// Adds the files of a case, `--profile`, `--set`, `--settings-file` and `--layers`.
CaseOptionList add_case_options(CLI::App& options, CaseOptions& chosen, const std::string& about_files);

/// The case that the options ask for. Throws UsageError for a `--set` that is no key=value, and as study::asked_case.
study::AskedCase case_of(const CaseOptions& chosen);

/// key=value, as `--set` has it. Throws UsageError.
std::vector<Override> overrides_of(const std::vector<std::string>& sets);

CLI::Option* add_layers_option(CLI::App& options, std::string& file);

/// Adds the file behind the others if there is one. Throws InputError if it is no table of layers.
void take_layers(std::vector<std::string>& files, const std::string& layers);

}  // namespace keyblock
