// Adds the options by which every command takes a case: its files, choices for its drawing, profile and settings.
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
  std::vector<std::string> values;  ///< POINTER=VALUE
  std::string settings_file;
  DrawingOptions reading;
};

/// Added options, for commands that exclude some of them from others.
struct CaseOptionList {
  CLI::Option* files;
  CLI::Option* profile;
  CLI::Option* sets;
  CLI::Option* values;
  CLI::Option* settings_file;
  std::vector<CLI::Option*> reading;  ///< of the drawing
};

/// Adds the files of a case, `--profile`, `--set`, `--at`, `--settings-file` and the options of a drawing.
CaseOptionList add_case_options(CLI::App& options, CaseOptions& chosen, const std::string& about_files);

/// Returns the requested case. Throws UsageError for a `--set` that is not key=value, std::invalid_argument for an
/// `--at` that is not POINTER=VALUE; otherwise throws like asked_case.
AskedCase case_of(const CaseOptions& chosen);

/// Parses key=value pairs of `--set`. Throws UsageError.
std::vector<Override> overrides_of(const std::vector<std::string>& sets);

}  // namespace keyblock
