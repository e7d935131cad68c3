// The options by which every command takes a case: its files, what is said of its drawing, profile and settings.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "api/asked_case.hpp"
#include "app/input/drawing_options.hpp"

namespace keyblock {

struct CaseOptions {
  std::vector<std::string> paths;
  std::string profile;
  std::vector<std::string> sets;
  std::string settings_file;
  DrawingOptions reading;
};

/// The options that were added, for commands that exclude some of them from others.
struct CaseOptionList {
  CLI::Option* files;
  CLI::Option* profile;
  CLI::Option* sets;
  CLI::Option* settings_file;
  std::vector<CLI::Option*> reading;  ///< of the drawing
};

/// Adds the files of a case, `--profile`, `--set`, `--settings-file` and the options of a drawing.
CaseOptionList add_case_options(CLI::App& options, CaseOptions& chosen, const std::string& about_files);

/// The case that the options ask for. Throws UsageError for a `--set` that is no key=value, and as asked_case.
AskedCase case_of(const CaseOptions& chosen);

/// key=value, as `--set` has it. Throws UsageError.
std::vector<Override> overrides_of(const std::vector<std::string>& sets);

}  // namespace keyblock
